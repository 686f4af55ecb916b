# fusee_registry(Format PREFIX make_ stl.cpp ...), fusee_registry(Rules SUFFIX _rules FOLDER rules rules/shaft.cpp ...): a file registers by
# its name alone: stl.cpp defines `Format make_stl()`, rules/shaft.cpp `Rules shaft_rules()`. Writes format_registry.h and rules_registry.h
# with `kRegistered`, the names and functions by name, to be included inside the module's namespace. FOLDER: in which the files are, if it is
# another one than this.
function(fusee_registry type)
  cmake_parse_arguments(R "" "PREFIX;SUFFIX;FOLDER" "" ${ARGN})
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
    string(REPLACE "." "_" function "${R_PREFIX}${id}${R_SUFFIX}")
    string(APPEND declared "${type} ${function}();\n")
    string(APPEND listed "    {\"${id}\", ${function}},\n")
  endforeach()
  string(TOLOWER "${type}" name)
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}_registry.h" @ONLY CONTENT
       "${declared}struct Registered {\n    const char* id;\n    ${type} (*make)();\n};\ninline constexpr Registered kRegistered[] = {\n${listed}};\n")
endfunction()
