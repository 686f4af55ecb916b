# One place for the compiler's settings: language level, warnings, reproducible floating point.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()
find_program(LLD_PROGRAM ld.lld)
if(LLD_PROGRAM)
  add_link_options(-fuse-ld=lld)
endif()

# The heavy CGAL units take up to 2 GB each: at most two compile jobs at once, whatever ninja would start.
set_property(GLOBAL PROPERTY JOB_POOLS compile=2 link=2)
set(CMAKE_JOB_POOL_COMPILE compile)
set(CMAKE_JOB_POOL_LINK link)

add_library(fusee_options INTERFACE)
# No fused multiply-add: the same bytes from every build of the same source.
target_compile_options(fusee_options INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       $<$<BOOL:${FUSEE_WERROR}>:-Werror>)
target_compile_features(fusee_options INTERFACE cxx_std_20)
install(TARGETS fusee_options EXPORT fuseeTargets)
