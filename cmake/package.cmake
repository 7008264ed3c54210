# `cpack` makes two packages for Debian: terrview, and libterrview-dev for its libraries.
set(CPACK_GENERATOR DEB)
if(NOT CPACK_PACKAGE_CONTACT)  # who packages: cmake -DCPACK_PACKAGE_CONTACT="Name <address>"
  set(CPACK_PACKAGE_CONTACT "terrview maintainers <maintainers@terrview.invalid>")
endif()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "what can be seen of a landscape from a point on the Earth")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_OUTPUT_FILE_PREFIX ${PROJECT_BINARY_DIR}/packages)

# Debian's own files join those of `cmake --install`.
set(CPACK_COMPONENTS_ALL program program_debian development development_debian)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_PROGRAM_GROUP terrview)
set(CPACK_COMPONENT_PROGRAM_DEBIAN_GROUP terrview)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)
set(CPACK_COMPONENT_DEVELOPMENT_DEBIAN_GROUP development)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_TERRVIEW_PACKAGE_NAME terrview)
set(CPACK_DEBIAN_TERRVIEW_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TERRVIEW_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TERRVIEW_PACKAGE_DEPENDS fonts-dejavu-core)  # for labels
set(CPACK_DEBIAN_TERRVIEW_DESCRIPTION
"terrview reads elevation models, puts an eye at a latitude, longitude and
height, and ray traces the terrain exactly: hidden parts, cast shadows,
light from the sky, the blue of the air, buildings and trees. For every
pixel it can write the distance, the place and the height of the ground
seen there.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libterrview-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
  "The static libraries, the headers and the CMake package of terrview.")

# The packages of what cmake/libraries.cmake finds: the lines up to an empty one.
file(READ cmake/packages.txt needed)
string(REGEX REPLACE ".*\n# Libraries[^\n]*\n(([^\n]+\n)+).*" "\\1" needed "${needed}")
string(REGEX REPLACE "[ \t]*#[^\n]*" "" needed "${needed}")
string(REGEX MATCHALL "[^\n]+" needed "${needed}")
list(JOIN needed ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)

string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)  # or SOURCE_DATE_EPOCH
configure_file(packaging/changelog.in ${generated}/changelog.Debian @ONLY)
add_custom_command(OUTPUT ${generated}/changelog.Debian.gz ${generated}/changelog.gz
  COMMAND gzip -9nkf ${generated}/changelog.Debian
  COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md > ${generated}/changelog.gz
  DEPENDS ${generated}/changelog.Debian CHANGELOG.md VERBATIM)
add_custom_target(changelogs ALL DEPENDS ${generated}/changelog.gz)
foreach(package program:terrview development:libterrview-dev)
  string(REPLACE ":" ";" package ${package})
  list(POP_FRONT package component)
  install(FILES packaging/copyright ${generated}/changelog.Debian.gz ${generated}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component}_debian EXCLUDE_FROM_ALL)
endforeach()
# Where Debian's zsh looks.
install(FILES packaging/_terrview DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
  COMPONENT program_debian EXCLUDE_FROM_ALL)
include(CPack)
