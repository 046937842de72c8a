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
    if(NOT include MATCHES "^#include (<[a-z_]+>|<std(def|int)\\.h>|\"weft/[a-z_/]+\\.h\")$")
      fail("${header}: ${include}: a public header may include the standard library and weft/ only")
    endif()
  endforeach()

  file(WRITE ${folder}/alone.cpp "#include \"${header}\"\n#include \"${header}\"\n")
  run(${cxx_compiler} -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Werror -fsyntax-only
    -I ${folder}/prefix/include ${folder}/alone.cpp)
endforeach()

# What a host writes with any of the settings must not warn there either.
run(${cxx_compiler} -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I ${folder}/prefix/include
  ${CMAKE_CURRENT_LIST_DIR}/designated_initialisers.cpp)

# Nor do the whole interfaces and the hosts in demo/embed, by any compiler that is there; and what cannot have C++20 is told.
set(warnings -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsyntax-only -I ${folder}/prefix/include)
foreach(name gcc clang)
  find_program(c_${name} ${name})
  string(REPLACE gcc g++ cxx ${name})
  string(REPLACE clang clang++ cxx ${cxx})
  find_program(cxx_${name} ${cxx})
  if(NOT c_${name} OR NOT cxx_${name})
    continue()
  endif()
  run(${c_${name}} -std=c99 ${warnings} ${weft_source}/demo/embed/flag.c ${weft_source}/demo/embed/plug_in.c)
  run(${cxx_${name}} -std=c++20 -Wold-style-cast ${warnings} ${weft_source}/demo/embed/main.cpp ${weft_source}/demo/embed/dressed.cpp)
  file(WRITE ${folder}/older.cpp "#include <weft/weft_c.h>\nint main() { return weft_version() > 0 ? 0 : 1; }\n")
  run(${cxx_${name}} -std=c++11 -Wold-style-cast ${warnings} ${folder}/older.cpp)
  file(WRITE ${folder}/older.cpp "#include <weft/weft.h>\n")
  execute_process(COMMAND ${cxx_${name}} -std=c++17 ${warnings} ${folder}/older.cpp RESULT_VARIABLE result ERROR_VARIABLE told)
  if(result EQUAL 0 OR NOT told MATCHES "C\\+\\+ interface needs C\\+\\+20")
    fail("weft.h does not tell a C++17 host what it needs:\n${told}")
  endif()
endforeach()
list(LENGTH headers count)
message(STATUS "${count} headers compile alone")
file(REMOVE_RECURSE ${folder})
