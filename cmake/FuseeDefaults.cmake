# One place for the compiler's settings: language level, warnings, reproducible floating point.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2")  # asserts stay on

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Depend mode: a unit that is not in the cache is not preprocessed twice.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_DEPEND=1 "${CCACHE_PROGRAM}")
endif()
find_program(LLD_PROGRAM ld.lld)
if(LLD_PROGRAM)
  add_link_options(-fuse-ld=lld)
endif()

# The heavy CGAL units take up to 2 GB each: one compile job per 2 GB of memory and per core, whatever ninja would start.
if(NOT FUSEE_JOBS)
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  cmake_host_system_information(RESULT memory_mib QUERY TOTAL_PHYSICAL_MEMORY)
  if(EXISTS "/sys/fs/cgroup/memory.max")  # a container's limit is below the machine's memory
    file(STRINGS "/sys/fs/cgroup/memory.max" limit LIMIT_COUNT 1)
    if(limit MATCHES "^[0-9]+$")
      math(EXPR limit_mib "${limit} / 1048576")
      if(limit_mib LESS memory_mib)
        set(memory_mib ${limit_mib})
      endif()
    endif()
  endif()
  math(EXPR FUSEE_JOBS "(${memory_mib} + 512) / 2048")  # + 512: a machine sold with 4 GB reports a little less
  if(FUSEE_JOBS GREATER cores)
    set(FUSEE_JOBS ${cores})
  elseif(FUSEE_JOBS LESS 1)
    set(FUSEE_JOBS 1)
  endif()
endif()
set_property(GLOBAL PROPERTY JOB_POOLS compile=${FUSEE_JOBS} link=${FUSEE_JOBS})
set(CMAKE_JOB_POOL_COMPILE compile)
set(CMAKE_JOB_POOL_LINK link)

# The warnings are the project's own affair: whoever links an installed module does not inherit them.
add_library(fusee_options INTERFACE)
target_compile_features(fusee_options INTERFACE cxx_std_20)
target_compile_options(fusee_options INTERFACE
  "$<BUILD_INTERFACE:-ffp-contract=off>"  # no fused multiply-add: the same bytes from every build of the same source
  "$<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion>"
  # clang warns of what g++ does: signs are not part of g++'s -Wconversion, nor elided braces of its -Wall, and a module may silence a warning
  # that only g++ has
  "$<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion;-Wno-missing-braces;-Wno-unknown-warning-option>>"
  "$<BUILD_INTERFACE:$<$<BOOL:${FUSEE_WERROR}>:-Werror>>")
set_target_properties(fusee_options PROPERTIES EXPORT_NAME options)
install(TARGETS fusee_options EXPORT fuseeTargets COMPONENT dev)
