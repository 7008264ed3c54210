# Every library the project uses, with the oldest version it is tested with (Debian 12).
find_package(GDAL 3.6 CONFIG REQUIRED)
find_package(PROJ 9.1 CONFIG REQUIRED)
find_package(glm 0.9.9 CONFIG REQUIRED)
# Debian's package speaks of Python bindings that it lacks, and its target names OpenCV's include
# folder, which it does not depend on.
set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
find_package(hwy 1.0 CONFIG REQUIRED)
find_package(OpenImageIO 2.4 CONFIG REQUIRED)
unset(CMAKE_MESSAGE_LOG_LEVEL)
if(NOT EXISTS /usr/include/opencv4)
  foreach(property INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
    get_target_property(folders OpenImageIO::OpenImageIO ${property})
    list(REMOVE_ITEM folders /usr/include/opencv4)
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES ${property} "${folders}")
  endforeach()
endif()
find_package(nlohmann_json 3.11 CONFIG REQUIRED)
find_package(CLI11 2.1 CONFIG REQUIRED)
find_package(TBB 2021.8 CONFIG REQUIRED)
find_package(Freetype 2.12 REQUIRED)

# Debian ships GeographicLib with a find module instead of a CMake package.
list(APPEND CMAKE_MODULE_PATH /usr/share/cmake/geographiclib)
find_package(GeographicLib 2.1 REQUIRED)
if(NOT TARGET GeographicLib::GeographicLib)
  add_library(GeographicLib::GeographicLib INTERFACE IMPORTED)
  target_link_libraries(GeographicLib::GeographicLib INTERFACE ${GeographicLib_LIBRARIES})
  target_include_directories(GeographicLib::GeographicLib INTERFACE ${GeographicLib_INCLUDE_DIRS})
endif()

# libnova comes with neither a CMake package nor a pkg-config file.
find_path(LIBNOVA_INCLUDE_DIR libnova/libnova.h REQUIRED)
find_library(LIBNOVA_LIBRARY nova REQUIRED)
add_library(libnova::libnova INTERFACE IMPORTED)
target_link_libraries(libnova::libnova INTERFACE ${LIBNOVA_LIBRARY})
target_include_directories(libnova::libnova INTERFACE ${LIBNOVA_INCLUDE_DIR})

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
