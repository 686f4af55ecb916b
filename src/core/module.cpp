#include "fusee/core/module.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "fusee/core/error.h"

namespace fusee::core {

namespace {

namespace fs = std::filesystem;

/// The file that holds this code: Python's module, else the program. The linker knows the program by its first argument only, which has no
/// folder where the shell found it in PATH.
fs::path own_file() {
    Dl_info self{};
    const bool known = ::dladdr(reinterpret_cast<const void*>(&loaded_function), &self) != 0 && self.dli_fname != nullptr;
    std::error_code ignored;
    return fs::canonical(known && fs::path(self.dli_fname).has_parent_path() ? self.dli_fname : "/proc/self/exe", ignored);
}

/// Where a library of fusee's own may be.
std::vector<fs::path> library_files(const std::string& name) {
    std::vector<fs::path> files;
    if (const fs::path folder = own_file().parent_path(); !folder.empty())
        for (const char* below : {"", "../" FUSEE_LIBDIR "/fusee", "../../" FUSEE_LIBDIR "/fusee"})
            files.push_back((folder / below / name).lexically_normal());
    files.push_back(fs::path(FUSEE_FULL_LIBDIR "/fusee") / name);
    return files;
}

}  // namespace

void* loaded_function(const std::string& library, const char* function) {
    std::string reasons;
    for (const fs::path& file : library_files(library)) {
        if (void* loaded = ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL))
            if (void* found = ::dlsym(loaded, function)) return found;
        reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", ::dlerror());
    }
    throw IoError(library, reasons);
}

}  // namespace fusee::core
