# What the embedding tests share.

# Ends the test, without leaving its folder behind.
function(fail message)
  file(REMOVE_RECURSE "${folder}")
  message(FATAL_ERROR "${message}")
endfunction()

# Runs a command; the test fails with its output when the command fails.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    fail("${command}\nended with ${result}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# Sets `folder` to a fresh one in the system's place for temporary files, which is not in the build tree.
function(make_temporary_folder)
  run(mktemp -d -t weft_embedding.XXXXXX)
  string(STRIP "${output}" output)
  set(folder ${output} PARENT_SCOPE)
endfunction()

# Configures demo/embed, given how it finds Weft.
function(configure_embedding_host)
  set(warnings "-Wall -Wextra -Wpedantic -Wconversion -Werror")
  run(${CMAKE_COMMAND} -S ${weft_source}/demo/embed -B ${folder}/build -G ${generator}
    -D CMAKE_C_COMPILER=${c_compiler}
    -D CMAKE_CXX_COMPILER=${cxx_compiler}
    -D CMAKE_CXX_COMPILER_LAUNCHER=${compiler_launcher}
    -D CMAKE_BUILD_TYPE=${build_type}
    "-DCMAKE_C_FLAGS=${warnings}"
    ${ARGN})
endfunction()

# Builds and runs it as well, and checks what it prints.
function(run_embedding_host)
  configure_embedding_host(${ARGN})
  run(${CMAKE_COMMAND} --build ${folder}/build)
  run(${folder}/build/weft_embed)
  if(NOT output MATCHES "step 300: 1536 particles")
    fail("weft_embed ran, but did not report its last step:\n${output}")
  endif()
  message(STATUS "${output}")
  run(${folder}/build/weft_embed_c)
  if(NOT output MATCHES "after 2 s the flag's far corner is at \\([01]\\.")
    fail("weft_embed_c ran, but its flag does not wave:\n${output}")
  endif()
  message(STATUS "${output}")
endfunction()

# Sets `symbols` to what a shared library shows, by its names in the source.
function(list_symbols library)
  run(nm --dynamic --defined-only --demangle --format=posix ${library})
  string(REGEX REPLACE "\n$" "" output "${output}")
  string(REGEX REPLACE "[;\\[]" "" output "${output}")  # which would make or join items of a list
  string(REPLACE "]" "" output "${output}")
  string(REPLACE "\n" ";" symbols "${output}")
  set(symbols ${symbols} PARENT_SCOPE)
endfunction()
