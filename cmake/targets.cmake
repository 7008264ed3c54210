# terrview_precompile(<target> <headers...>): has these, and what most sources include, read once for
# the whole target. In builds without sanitizers for test programs alone: elsewhere a source that lacks
# an include is to fail, and gcc 12 warns falsely of a precompiled <string>.
function(terrview_precompile target)
  get_target_property(type ${target} TYPE)
  if(TERRVIEW_PRECOMPILE AND (TERRVIEW_SANITIZE OR type STREQUAL EXECUTABLE))
    target_precompile_headers(${target} PRIVATE
      <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <set> <span> <string>
      <vector> <glm/common.hpp> <glm/geometric.hpp> <glm/matrix.hpp> ${ARGN})
    target_compile_options(${target} PRIVATE
      "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow>")
  endif()
endfunction()

# terrview_vector_code(<name>): the library has code that Highway compiles for every instruction set.
function(terrview_vector_code name)
  # Where there are no vectors, a lane at a time: what gcc 12 does anyway, and half the code of emulated ones.
  target_compile_definitions(terrview_${name} PRIVATE HWY_BROKEN_EMU128=1)
  if(TERRVIEW_SANITIZE)
    target_compile_definitions(terrview_${name} PRIVATE TERRVIEW_SANITIZED)
    set(ignored ${PROJECT_SOURCE_DIR}/cmake/ignored_by_sanitizers.txt)
    target_compile_options(terrview_${name} PRIVATE
      $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${ignored}>)
  endif()
endfunction()

# terrview_compile_fast(<target>): not optimised in builds with sanitizers, and a test program hardly in
# others. For targets whose own code does not run for long.
function(terrview_compile_fast target)
  get_target_property(type ${target} TYPE)
  if(TERRVIEW_SANITIZE AND NOT TERRVIEW_FUZZ)
    target_compile_options(${target} PRIVATE -O0)
  elseif(type STREQUAL EXECUTABLE)
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()

# terrview_library(<folder> <public libraries...>): the static library of one folder's sources, which
# other projects know as terrview::<folder>.
function(terrview_library folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp *.h)
  add_library(terrview_${folder} STATIC ${sources})
  target_link_libraries(terrview_${folder} PUBLIC terrview_flags ${ARGN})
  add_library(terrview::${folder} ALIAS terrview_${folder})
  set_target_properties(terrview_${folder} PROPERTIES EXPORT_NAME ${folder})
  terrview_precompile(terrview_${folder})
endfunction()

# terrview_test(<name> <folder of tests> [EXCLUDE <regex>] [PRECOMPILE <header>] <libraries...>): one
# test program per folder, of the sources that do not match. Test suites whose names end in "Long"
# carry the ctest label `long`. PRECOMPILE names a header that most of them include.
function(terrview_test name folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "EXCLUDE;PRECOMPILE" "")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  if(arg_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX "${arg_EXCLUDE}")
  endif()
  if(NOT sources)
    return()
  endif()
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE terrview_flags ${arg_UNPARSED_ARGUMENTS} rapidcheck GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE TERRVIEW_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  terrview_compile_fast(${name})
  list(LENGTH sources count)
  if(count GREATER 4)
    terrview_precompile(${name} <gtest/gtest.h> ${arg_PRECOMPILE})
  endif()
  # The second pattern is that of typed suites, TracerLong/0.Name.
  set(long "*Long.*:*Long/*.*")
  if(TERRVIEW_TEST_SHARDS OR TERRVIEW_SANITIZE)
    # A process with sanitizers takes so long to start that a test each would spend most of the time so.
    math(EXPR shards "(${count} + 3) / 4")
    if(shards GREATER 12)
      set(shards 12)
    endif()
    foreach(shard RANGE 1 ${shards})
      math(EXPR index "${shard} - 1")
      add_test(NAME ${name}.${shard}_of_${shards} COMMAND ${name} --gtest_filter=-${long})
      set_tests_properties(${name}.${shard}_of_${shards} PROPERTIES
        ENVIRONMENT "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}")
    endforeach()
  else()
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 TEST_FILTER "-${long}")
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 TEST_FILTER "${long}" PROPERTIES LABELS long)
endfunction()
