# find_package(Candela) -> Candela::candela. The libraries are static, so what they stand on has to be
# there too; the list is the one the build itself uses.
include(${CMAKE_CURRENT_LIST_DIR}/CandelaDependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/CandelaTargets.cmake)
