# What `cmake --install` installs, in components: `program` (the program, its manual, completion), `zsh`
# (zsh's completion, which Debian has elsewhere) and `development` (libraries, headers, the CMake
# package).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(libraries terrview_terrain terrview_sky terrview_render terrview_quantize terrview_ingest)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/terrview)
set(document_folder ${CMAKE_INSTALL_DATADIR}/doc/terrview)
set(generated ${PROJECT_BINARY_DIR}/packaging)

# The man page is docs/cli.md in another form.
set(manual ${generated}/terrview.1)
add_custom_command(OUTPUT ${manual}.gz
  COMMAND awk -v version=${PROJECT_VERSION} -f ${PROJECT_SOURCE_DIR}/packaging/manual.awk
          ${PROJECT_SOURCE_DIR}/docs/cli.md > ${manual}
  COMMAND gzip -9nkf ${manual}
  BYPRODUCTS ${manual}
  DEPENDS packaging/manual.awk docs/cli.md VERBATIM)
add_custom_target(manual ALL DEPENDS ${manual}.gz)

install(TARGETS terrview COMPONENT program)
install(FILES ${manual}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES packaging/terrview.bash RENAME terrview
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES packaging/_terrview DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions
  COMPONENT zsh)
install(DIRECTORY docs/ DESTINATION ${document_folder} COMPONENT program)
install(FILES LICENSE DESTINATION ${document_folder} COMPONENT program)
install(DIRECTORY samples/scenes DESTINATION ${document_folder}/examples COMPONENT program)
install(FILES samples/vosges_like.tif DESTINATION ${document_folder}/examples COMPONENT program)

install(TARGETS terrview_flags ${libraries} EXPORT terrview COMPONENT development)
set_target_properties(terrview_flags PROPERTIES EXPORT_NAME flags)
install(EXPORT terrview FILE terrviewTargets.cmake NAMESPACE terrview:: DESTINATION ${package_folder}
  COMPONENT development)
configure_package_config_file(cmake/terrviewConfig.cmake.in ${generated}/terrviewConfig.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${generated}/terrviewConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${generated}/terrviewConfig.cmake ${generated}/terrviewConfigVersion.cmake
  cmake/libraries.cmake DESTINATION ${package_folder} COMPONENT development)
install(CODE "set(source \"${PROJECT_SOURCE_DIR}\")" COMPONENT development)
install(SCRIPT cmake/install_headers.cmake COMPONENT development)
