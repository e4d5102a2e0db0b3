# The installed package: programs, man pages, completion, schemas, samples, and for find_package(cgw)
# cgw_embed_config, the program cgw::cgw and the freestanding rooms as sources, cgw::image and so on. The C reader
# of images is a header.
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/cgw")
set(data "${CMAKE_INSTALL_DATAROOTDIR}/cgw")
get_property(CGW_INSTALLED_ROOMS GLOBAL PROPERTY CGW_FREESTANDING_ROOMS)

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/cgwConfig.cmake.in" "${PROJECT_BINARY_DIR}/cgwConfig.cmake"
  INSTALL_DESTINATION "${package}" PATH_VARS data)
# 0.x: another minor version may change what a consumer builds on.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/cgwConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)

install(EXPORT cgwTargets NAMESPACE cgw:: DESTINATION "${package}")
install(FILES
  "${PROJECT_BINARY_DIR}/cgwConfig.cmake"
  "${PROJECT_BINARY_DIR}/cgwConfigVersion.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/CgwEmbedConfig.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/CgwRoom.cmake"
  DESTINATION "${package}")
foreach(room IN LISTS CGW_INSTALLED_ROOMS)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/lib/${room}" DESTINATION "${data}/rooms"
          FILES_MATCHING PATTERN "*.hpp" PATTERN "*.cpp" PATTERN "CMakeLists.txt")
endforeach()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/schemas" "${PROJECT_SOURCE_DIR}/samples" DESTINATION "${data}")
install(FILES "${PROJECT_SOURCE_DIR}/lib/image/c/cgw_image.h" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/cgw")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs/" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
        DESTINATION "${CMAKE_INSTALL_DOCDIR}")
