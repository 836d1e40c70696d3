# `cmake --install`: programs, headers, libraries, assets, and the package that gives embedders
# `find_package(Candela)` and the target `Candela::candela`. Programs install themselves.
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY CANDELA_LIBRARIES)
add_library(candela_all INTERFACE)
add_library(Candela::candela ALIAS candela_all)
set_target_properties(candela_all PROPERTIES EXPORT_NAME candela)
target_link_libraries(candela_all INTERFACE ${libraries})
target_include_directories(candela_all INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)

install(TARGETS candela_all candela_flags ${libraries} EXPORT CandelaTargets ARCHIVE)
# Inside the library an include starts with the folder ("base/result.h"), so the folders of src/ keep
# their names below include/candela/.
install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/candela FILES_MATCHING PATTERN "*.h")
install(FILES include/candela/candela.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/candela)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY assets/ DESTINATION ${CMAKE_INSTALL_DATADIR}/candela/assets OPTIONAL)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Candela)
install(EXPORT CandelaTargets NAMESPACE Candela:: DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/CandelaConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/CandelaConfig.cmake cmake/CandelaDependencies.cmake
              ${PROJECT_BINARY_DIR}/CandelaConfigVersion.cmake DESTINATION ${package})
