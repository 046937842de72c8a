# demo/embed against the installed package, as find_package(weft) and pkg-config find it: out of the Debian package, where
# those can be made.
cmake_minimum_required(VERSION 3.23)
include(${CMAKE_CURRENT_LIST_DIR}/host.cmake)
make_temporary_folder()
find_program(dpkg dpkg-deb)
if(dpkg)
  run(${CMAKE_CPACK_COMMAND} -G DEB --config ${weft_build}/CPackConfig.cmake -B ${folder}/deb)
  file(GLOB package ${folder}/deb/libweft-dev_*.deb)
  run(${dpkg} --extract ${package} ${folder}/root)
  file(REMOVE_RECURSE ${folder}/deb)
  set(prefix ${folder}/root/usr)
else()
  set(prefix ${folder}/prefix)
  run(${CMAKE_COMMAND} --install ${weft_build} --prefix ${prefix})
endif()
file(GLOB_RECURSE installed RELATIVE ${prefix} ${prefix}/*)
foreach(wanted LICENSE CHANGELOG.md weft_c.h weftConfig.cmake weft.pc)
  if(NOT installed MATCHES "/${wanted}(;|$)")
    fail("${wanted} is not among what was installed: ${installed}")
  endif()
endforeach()
run_embedding_host(-D CMAKE_PREFIX_PATH=${prefix})

# A plug-in that has the library inside shows none of it.
function(expect_own_function_only plug_in)
  list_symbols(${plug_in})
  list(FILTER symbols EXCLUDE REGEX "^(height_of_falling_cloth|_init|_fini) ")
  if(symbols)
    fail("a plug-in shows more than its own function: ${symbols}")
  endif()
endfunction()
expect_own_function_only(${folder}/build/libweft_embed_plug_in.so)

find_program(pkg_config pkg-config)
if(pkg_config)
  file(GLOB_RECURSE pc ${prefix}/weft.pc)
  get_filename_component(pc_folder ${pc} DIRECTORY)
  run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pc_folder} ${pkg_config} --cflags --libs weft)
  separate_arguments(flags UNIX_COMMAND "${output}")
  run(${c_compiler} -std=c99 ${weft_source}/demo/embed/flag.c -o ${folder}/flag ${flags})
  run(${folder}/flag)
  run(${c_compiler} -std=c99 -shared -fPIC ${weft_source}/demo/embed/plug_in.c -o ${folder}/plug_in.so ${flags})
  expect_own_function_only(${folder}/plug_in.so)
endif()

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
    -D CMAKE_PREFIX_PATH=${prefix}
    -D CMAKE_DISABLE_FIND_PACKAGE_Eigen3=TRUE)
endif()

# So does weft::gltf, where its build's JSON library is not.
if(EXISTS ${weft_build}/demo/gltf)
  file(WRITE ${folder}/gltf/main.cpp "#include <weft/gltf.h>
#include <cstdio>
int main() {
    const auto asset = weft::GltfAsset::load(\"none.glb\");
    if (!asset) std::puts(asset.error().message.c_str());
    return asset.ok() ? 1 : 0;
}
")
  file(WRITE ${folder}/gltf/CMakeLists.txt "cmake_minimum_required(VERSION 3.23)
project(host CXX)
find_package(weft REQUIRED COMPONENTS gltf)
add_executable(host main.cpp)
target_link_libraries(host PRIVATE weft::gltf)
")
  run(${CMAKE_COMMAND} -S ${folder}/gltf -B ${folder}/gltf-build
    -D CMAKE_CXX_COMPILER=${cxx_compiler}
    -D CMAKE_PREFIX_PATH=${prefix}
    -D CMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=TRUE)
  run(${CMAKE_COMMAND} --build ${folder}/gltf-build)
  run(${folder}/gltf-build/host)
  if(NOT output MATCHES "none.glb: cannot be read")
    fail("a host with weft::gltf ran, but was told nothing:\n${output}")
  endif()
endif()
file(REMOVE_RECURSE ${folder})
