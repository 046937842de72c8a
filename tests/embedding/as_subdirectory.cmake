# demo/embed with Weft as a part of its own build, by add_subdirectory.
cmake_minimum_required(VERSION 3.23)
include(${CMAKE_CURRENT_LIST_DIR}/host.cmake)
make_temporary_folder()
run_embedding_host(-D WEFT_SOURCE_DIR=${weft_source})
file(REMOVE_RECURSE ${folder})
