# What `cmake --install` leaves behind: the libraries, the public headers, and a package by which find_package(weft)
# gives weft::weft, and weft::render where it was built.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(weft_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/weft)

# weft_install(export rooms...): the rooms' libraries as weft::<room>, and their headers in include/weft.
function(weft_install export)
  foreach(room IN LISTS ARGN)
    set_target_properties(weft_${room} PROPERTIES EXPORT_NAME ${room})
    install(TARGETS weft_${room} EXPORT ${export})
    install(DIRECTORY ${room}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h)
  endforeach()
  install(EXPORT ${export} NAMESPACE weft:: DESTINATION ${weft_package_dir})
endfunction()

set_target_properties(weft_options PROPERTIES EXPORT_NAME options)
install(TARGETS weft weft_options EXPORT weftTargets)
weft_install(weftTargets engine collision cloth)
if(WEFT_BUILD_RENDER)
  weft_install(weftRenderTargets render)
endif()

configure_package_config_file(engine/cmake/weftConfig.cmake.in weftConfig.cmake INSTALL_DESTINATION ${weft_package_dir})
write_basic_package_version_file(weftConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/weftConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/weftConfigVersion.cmake
  DESTINATION ${weft_package_dir})
