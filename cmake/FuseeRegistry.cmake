# fusee_registry(Rule [PREFIX make_] [FOLDER folder] a/b.cpp ...): a file registers by its place alone: cable/bend_ratio.cpp defines `Rule cable_bend_ratio()`,
# found under the id "cable.bend_ratio"; with PREFIX make_ it is `make_cable_bend_ratio()`. Writes rule_registry.h with `kRegistered`, the ids
# and functions by id, to be included inside the module's namespace. FOLDER: in which the files are, if it is another one than this.
function(fusee_registry type)
  cmake_parse_arguments(R "" "PREFIX;FOLDER" "" ${ARGN})
  if(NOT R_FOLDER)
    set(R_FOLDER "${CMAKE_CURRENT_SOURCE_DIR}")
  endif()
  set(declared "")
  set(listed "")
  list(SORT R_UNPARSED_ARGUMENTS)
  foreach(file IN LISTS R_UNPARSED_ARGUMENTS)
    file(RELATIVE_PATH id "${R_FOLDER}" "${file}")
    string(REGEX REPLACE "\\.cpp$" "" id "${id}")
    string(REPLACE "/" "." id "${id}")
    string(REPLACE "." "_" function "${R_PREFIX}${id}")
    string(APPEND declared "${type} ${function}();\n")
    string(APPEND listed "    {\"${id}\", ${function}},\n")
  endforeach()
  string(TOLOWER "${type}" name)
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}_registry.h" @ONLY CONTENT
       "${declared}struct Registered {\n    const char* id;\n    ${type} (*make)();\n};\ninline constexpr Registered kRegistered[] = {\n${listed}};\n")
endfunction()
