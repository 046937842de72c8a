# demo/embed against the installed package, by find_package(weft).
cmake_minimum_required(VERSION 3.23)
include(${CMAKE_CURRENT_LIST_DIR}/host.cmake)
make_temporary_folder()
run(${CMAKE_COMMAND} --install ${weft_build} --prefix ${folder}/prefix)
run_embedding_host(-D CMAKE_PREFIX_PATH=${folder}/prefix)

# weft::render comes along, too, where its build's own tools are not: neither Eigen nor stb, which Debian's imgui.pc names.
if(EXISTS ${weft_build}/render)
  file(WRITE ${folder}/pc/imgui.pc "Name: imgui\nDescription: imgui\nVersion: 1.86\nLibs: -limgui\n")
  file(WRITE ${folder}/render/CMakeLists.txt "cmake_minimum_required(VERSION 3.23)
project(host CXX)
find_package(weft REQUIRED COMPONENTS render)
if(NOT TARGET weft::render)
  message(FATAL_ERROR \"no weft::render\")
endif()
")
  run(${CMAKE_COMMAND} -E env PKG_CONFIG_LIBDIR=${folder}/pc ${CMAKE_COMMAND} -S ${folder}/render -B ${folder}/render-build
    -D CMAKE_CXX_COMPILER=${cxx_compiler}
    -D CMAKE_PREFIX_PATH=${folder}/prefix
    -D CMAKE_DISABLE_FIND_PACKAGE_Eigen3=TRUE)
endif()
file(REMOVE_RECURSE ${folder})
