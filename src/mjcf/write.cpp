#include "fusee/mjcf/write.h"

#include "fusee/core/file.h"

// The assembler copies the companion programs, which are files of their own: editors and node read them as they are.
#define FUSEE_EMBED(name, file)                                                                                           \
    asm(".pushsection .rodata\n" #name "_begin:\n.incbin \"" FUSEE_COMPANION "/" file "\"\n" #name "_end:\n.popsection"); \
    extern "C" const char name##_begin[] __attribute__((visibility("hidden")));                                           \
    extern "C" const char name##_end[] __attribute__((visibility("hidden")))

FUSEE_EMBED(fusee_twin_mjs, "joint_twin.mjs");
FUSEE_EMBED(fusee_twin_py, "joint_twin.py");

namespace fusee::mjcf {

std::string_view companion_javascript() { return {fusee_twin_mjs_begin, fusee_twin_mjs_end}; }
std::string_view companion_python() { return {fusee_twin_py_begin, fusee_twin_py_end}; }

void write(const Twin& twin, const std::filesystem::path& folder) {
    core::write_file(folder / kModelFile, model_xml(twin));
    core::write_file(folder / kLawsFile, laws_json(twin));
    core::write_file(folder / kJavaScriptFile, companion_javascript());
    core::write_file(folder / kPythonFile, companion_python());
}

}  // namespace fusee::mjcf
