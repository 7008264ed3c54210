# The libraries that terrview's own are linked with, each with the oldest version it is tested with
# (Debian 12). The build reads this file, and so does find_package(terrview).
include(CMakeFindDependencyMacro)
find_dependency(GDAL 3.6 CONFIG)
find_dependency(PROJ 9.1 CONFIG)
find_dependency(glm 0.9.9 CONFIG)
# Debian's package speaks of Python bindings that it lacks, and its target names OpenCV's include
# folder, which it does not depend on.
set(terrview_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
find_package(hwy 1.0 CONFIG QUIET)
find_package(OpenImageIO 2.4 CONFIG QUIET)
set(CMAKE_MESSAGE_LOG_LEVEL "${terrview_log_level}")
if(NOT hwy_FOUND)
  find_dependency(hwy 1.0 CONFIG)  # which says so and returns
elseif(NOT OpenImageIO_FOUND)
  find_dependency(OpenImageIO 2.4 CONFIG)
endif()
if(NOT EXISTS /usr/include/opencv4)
  foreach(property INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
    get_target_property(folders OpenImageIO::OpenImageIO ${property})
    list(REMOVE_ITEM folders /usr/include/opencv4)
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES ${property} "${folders}")
  endforeach()
endif()
find_dependency(nlohmann_json 3.11 CONFIG)
find_dependency(pugixml 1.13 CONFIG)
find_dependency(TBB 2021.8 CONFIG)
find_dependency(Freetype 2.12)

# Debian ships GeographicLib with a find module instead of a CMake package.
list(APPEND CMAKE_MODULE_PATH /usr/share/cmake/geographiclib)
find_dependency(GeographicLib 2.1)
list(REMOVE_ITEM CMAKE_MODULE_PATH /usr/share/cmake/geographiclib)
if(NOT TARGET GeographicLib::GeographicLib)
  add_library(GeographicLib::GeographicLib INTERFACE IMPORTED)
  target_link_libraries(GeographicLib::GeographicLib INTERFACE ${GeographicLib_LIBRARIES})
  target_include_directories(GeographicLib::GeographicLib INTERFACE ${GeographicLib_INCLUDE_DIRS})
endif()

# libnova comes with neither a CMake package nor a pkg-config file.
if(NOT TARGET libnova::libnova)
  find_path(LIBNOVA_INCLUDE_DIR libnova/libnova.h REQUIRED)
  find_library(LIBNOVA_LIBRARY nova REQUIRED)
  add_library(libnova::libnova INTERFACE IMPORTED)
  target_link_libraries(libnova::libnova INTERFACE ${LIBNOVA_LIBRARY})
  target_include_directories(libnova::libnova INTERFACE ${LIBNOVA_INCLUDE_DIR})
endif()
