# fusee_registry(Rule a/b.cpp ...): a file registers by its place alone: cable/bend_ratio.cpp defines `Rule cable_bend_ratio()`, found under
# the id "cable.bend_ratio". Writes rule_registry.h with `kRegistered`, the ids and functions by id, to be included inside the module's namespace.
function(fusee_registry type)
  set(declared "")
  set(listed "")
  list(SORT ARGN)
  foreach(file IN LISTS ARGN)
    file(RELATIVE_PATH id "${CMAKE_CURRENT_SOURCE_DIR}" "${file}")
    string(REGEX REPLACE "\\.cpp$" "" id "${id}")
    string(REPLACE "/" "." id "${id}")
    string(REPLACE "." "_" function "${id}")
    string(APPEND declared "${type} ${function}();\n")
    string(APPEND listed "    {\"${id}\", ${function}},\n")
  endforeach()
  string(TOLOWER "${type}" name)
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}_registry.h" @ONLY CONTENT
       "${declared}struct Registered {\n    const char* id;\n    ${type} (*make)();\n};\ninline constexpr Registered kRegistered[] = {\n${listed}};\n")
endfunction()
