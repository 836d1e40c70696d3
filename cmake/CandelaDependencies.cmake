# The libraries Candela stands on, all Debian packages. Each folder links only those it uses.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(ZLIB REQUIRED)
pkg_check_modules(spng REQUIRED IMPORTED_TARGET spng)
