#include "page/bundle.h"

#include <string_view>

// The assembler copies the files: compiling them as C++ literals takes seconds. FUSEE_WEB is the folder of the files.
#define FUSEE_EMBED(name, file)                                                                                     \
    asm(".pushsection .rodata\n" #name "_begin:\n.incbin \"" FUSEE_WEB "/" file "\"\n" #name "_end:\n.popsection"); \
    extern "C" const char name##_begin[] __attribute__((visibility("hidden")));                                     \
    extern "C" const char name##_end[] __attribute__((visibility("hidden")))

FUSEE_EMBED(fusee_plot_js, "plot.js");
FUSEE_EMBED(fusee_plot_css, "plot.css");
FUSEE_EMBED(fusee_joint_js, "joint.js");
FUSEE_EMBED(fusee_joint_css, "joint.css");

namespace fusee::report {

namespace {

std::string elements(std::string_view css, std::string_view script) {
    std::string out = "<style>";
    out.reserve(css.size() + script.size() + 40);
    return out.append(css).append("</style><script>").append(script).append("</script>\n");
}

}  // namespace

std::string plot_bundle() { return elements({fusee_plot_css_begin, fusee_plot_css_end}, {fusee_plot_js_begin, fusee_plot_js_end}); }
std::string joint_bundle() { return elements({fusee_joint_css_begin, fusee_joint_css_end}, {fusee_joint_js_begin, fusee_joint_js_end}); }

}  // namespace fusee::report
