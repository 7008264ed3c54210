# Compiler flags shared by every target. Those that decide results are exported with the headers, whose
# inline functions need them too; warnings and sanitizers are the build's own.
add_library(terrview_flags INTERFACE)
set(warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  # gcc 12 sees overlaps in every "text" + std::string (its bug 105651).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
target_compile_options(terrview_flags INTERFACE
  "$<BUILD_INTERFACE:${warnings}>"
  # gcc 12 at -O3 drops the rounding of double -> float -> double where two such conversions stand side
  # by side and become one vector. Costs nothing: the loops that matter are vectors by hand or by the
  # loop vectorizer.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-fno-tree-slp-vectorize>
  # The same bytes on every machine of one kind: no fused multiply-add, and never -ffast-math
  # (NaN means "no data").
  -ffp-contract=off)
if(TERRVIEW_WERROR)
  target_compile_options(terrview_flags INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
if(TERRVIEW_SANITIZE)
  target_compile_options(terrview_flags INTERFACE
    "$<BUILD_INTERFACE:-fsanitize=${TERRVIEW_SANITIZE};-fno-omit-frame-pointer;-fno-sanitize-recover=all>")
  target_link_options(terrview_flags INTERFACE $<BUILD_INTERFACE:-fsanitize=${TERRVIEW_SANITIZE}>)
endif()
# Vector code is compiled for SSE4, AVX2 and AVX-512; between SSE4 and none no machine is worth its time.
target_compile_definitions(terrview_flags INTERFACE $<BUILD_INTERFACE:HWY_DISABLED_TARGETS=HWY_SSSE3>)
target_compile_features(terrview_flags INTERFACE cxx_std_20)
target_include_directories(terrview_flags INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/terrview>)
