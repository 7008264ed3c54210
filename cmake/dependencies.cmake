# Every library the project uses, with the oldest version it is tested with (Debian 12).
set(CMAKE_FIND_PACKAGE_NAME terrview)  # whose dependencies they are, and all are required
set(terrview_FIND_REQUIRED ON)
include(cmake/libraries.cmake)
find_package(CLI11 2.1 CONFIG REQUIRED)

# xxHash is used as a header alone.
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)

# The rival in the benchmark, whose ray set-up is written for x86-64.
if(TERRVIEW_BENCH AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  find_package(embree 3 CONFIG)
endif()

if(TERRVIEW_TESTS)
  find_package(GTest 1.12 REQUIRED)
  find_package(rapidcheck CONFIG REQUIRED)
endif()
