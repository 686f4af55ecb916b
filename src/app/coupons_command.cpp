#include "arguments.h"
#include "fusee/pipeline/coupons.h"
#include "places.h"

namespace fusee::app {

namespace {

struct CouponsArguments {
    std::filesystem::path profile, out = "out";
    bool force = false;
};

int coupons(const CouponsArguments& arguments, Reply& reply) {
    const profile::Profile profile = profile::read_profile(arguments.profile);
    const pipeline::Coupons made = with_places(profile, [&] { return pipeline::make_coupons(profile, arguments.out, arguments.force); });
    reply.show(made.findings);
    if (!made.made) return 1;
    std::string names;
    Json files = Json::array();
    for (const pipeline::FileRow& file : made.files) {
        names += (names.empty() ? "" : ", ") + file.entry.name;
        files.push_back(file.entry.name);
    }
    reply.result["folder"] = made.folder.string(), reply.result["files"] = files;
    reply.say(fmt::format("written: {}: {}\n", made.folder.string(), names));
    return 0;
}

}  // namespace

void add_coupons(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "coupons", coupons);
    add_profile(*command, arguments->profile, "Profile (*.toml)");
    add_out(*command, arguments->out, "Folder that contains the result, the folder NAME-coupons");
    add_force(*command, arguments->force);
    command->footer(
        "Example:\n  fusee coupons profiles/pnrvsa.toml\n\n"
        "Exit code: 0 the coupons are made, 1 they cannot be made (the binding limit is printed), 2 bad input, 3 internal error.");
}

}  // namespace fusee::app
