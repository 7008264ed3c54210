# Installs the public headers of `source` into include/terrview: those of the libraries that the program
# itself is made from, and what they include. The others belong to the libraries' insides.

# included(<result> <folders, parted by bars> <files...>): what the files include from the folders.
function(included result folders)
  set(found)
  foreach(file ${ARGN})
    file(STRINGS ${source}/${file} lines REGEX "^#include \"(${folders})/")
    foreach(line ${lines})
      string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" header "${line}")
      list(APPEND found ${header})
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES found)
  set(${result} ${found} PARENT_SCOPE)
endfunction()

set(folders "terrain|sky|render|quantize|ingest")
file(GLOB_RECURSE program RELATIVE ${source} ${source}/cli/*.cpp ${source}/cli/*.h)
included(unread "${folders}" ${program})
set(headers)
while(unread)
  list(APPEND headers ${unread})
  included(unread "${folders}" ${unread})
  list(REMOVE_ITEM unread ${headers})
endwhile()

foreach(header ${headers})
  get_filename_component(folder ${header} DIRECTORY)
  file(INSTALL ${source}/${header} DESTINATION ${CMAKE_INSTALL_PREFIX}/include/terrview/${folder})
endforeach()
