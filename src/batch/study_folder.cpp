#include "study_folder.h"

#include "fusee/core/file.h"

namespace fs = std::filesystem;

namespace fusee::batch {

core::OutputFolder study_folder(const study::Plan& plan, const fs::path& out, bool force, const std::string& command,
                                std::vector<std::string> files) {
    const study::Study& study = plan.study();
    return {out,
            study.name,
            {.command = command,
             .source = study.varies() ? study.file : study.profiles.front(),
             .force = force,
             .files = std::move(files),
             .stays = true}};
}

void write_study_file(const study::Plan& plan, const fs::path& folder) {
    const study::Study& study = plan.study();
    std::string text;
    if (study.varies())
        text = core::read_file(study.file);
    else
        for (const fs::path& profile : study.profiles) text += "# " + profile.string() + "\n";
    core::write_file(folder / "study.toml", text);
}

core::OutputFolder claim_study_folder(const study::Plan& plan, const fs::path& out, bool force) {
    core::OutputFolder output = study_folder(plan, out, force);
    const auto place = output.find();
    if (!place || place->kind(core::kManifestName) == core::OpenFolder::Kind::kNone) {
        write_study_file(plan, output.path());
        output.commit();
    }
    return output;
}

}  // namespace fusee::batch
