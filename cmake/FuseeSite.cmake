# The documents as a site without external requests: `cmake --build build --target site` writes build/site, the API reference in
# build/site/api; the program prints the tables of rules and keys (site/hooks.py). Not part of a build: mkdocs and doxygen are in no list of packages that fusee needs.
find_program(MKDOCS_PROGRAM mkdocs)
find_program(DOXYGEN_PROGRAM doxygen)
if(MKDOCS_PROGRAM AND DOXYGEN_PROGRAM)
  option(FUSEE_API_PARAMETERS "doxygen also warns of each parameter without a word" OFF)
  set(FUSEE_API_PARAMETERS_WORD NO)
  if(FUSEE_API_PARAMETERS)
    set(FUSEE_API_PARAMETERS_WORD YES)
  endif()
  configure_file("${CMAKE_CURRENT_LIST_DIR}/site/Doxyfile.in" "${PROJECT_BINARY_DIR}/Doxyfile" @ONLY)
  add_custom_target(site
    COMMAND "${CMAKE_COMMAND}" -E env "FUSEE_PROGRAM=$<TARGET_FILE:fusee_app>" "${MKDOCS_PROGRAM}" build --strict --quiet --clean --config-file "${PROJECT_SOURCE_DIR}/mkdocs.yml" --site-dir "${PROJECT_BINARY_DIR}/site"
    COMMAND "${DOXYGEN_PROGRAM}" "${PROJECT_BINARY_DIR}/Doxyfile"
    COMMAND "${CMAKE_COMMAND}" -E echo "site/index.html; doxygen's warnings: site-doxygen.log"
    WORKING_DIRECTORY "${PROJECT_BINARY_DIR}" COMMENT "The documents as a site: site/index.html" VERBATIM)
endif()
