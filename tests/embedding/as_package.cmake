# demo/embed against the installed package, by find_package(weft).
cmake_minimum_required(VERSION 3.23)
include(${CMAKE_CURRENT_LIST_DIR}/host.cmake)
make_temporary_folder()
run(${CMAKE_COMMAND} --install ${weft_build} --prefix ${folder}/prefix)
run_embedding_host(-D CMAKE_PREFIX_PATH=${folder}/prefix)
file(REMOVE_RECURSE ${folder})
