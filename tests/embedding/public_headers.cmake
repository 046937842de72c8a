# Each installed header stands on its own and needs the standard library only.
cmake_minimum_required(VERSION 3.23)
include(${CMAKE_CURRENT_LIST_DIR}/host.cmake)
make_temporary_folder()
run(${CMAKE_COMMAND} --install ${weft_build} --prefix ${folder}/prefix)

file(GLOB_RECURSE headers RELATIVE ${folder}/prefix/include ${folder}/prefix/include/weft/*.h)
if(NOT "weft/weft.h" IN_LIST headers)
  fail("weft/weft.h is not among the installed headers: ${headers}")
endif()

foreach(header IN LISTS headers)
  # Headers of the standard library have neither folder nor extension; those of all other libraries have.
  file(STRINGS ${folder}/prefix/include/${header} includes REGEX "^ *# *include")
  foreach(include IN LISTS includes)
    if(NOT include MATCHES "^#include (<[a-z_]+>|\"weft/[a-z_/]+\\.h\")$")
      fail("${header}: ${include}: a public header may include the standard library and weft/ only")
    endif()
  endforeach()

  file(WRITE ${folder}/alone.cpp "#include \"${header}\"\n#include \"${header}\"\n")
  run(${cxx_compiler} -std=c++20 -Wall -Wextra -Wconversion -Wdouble-promotion -Werror -fsyntax-only
    -I ${folder}/prefix/include ${folder}/alone.cpp)
endforeach()

# What a host writes with any of the settings must not warn there either.
run(${cxx_compiler} -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I ${folder}/prefix/include
  ${CMAKE_CURRENT_LIST_DIR}/designated_initialisers.cpp)
list(LENGTH headers count)
message(STATUS "${count} headers compile alone")
file(REMOVE_RECURSE ${folder})
