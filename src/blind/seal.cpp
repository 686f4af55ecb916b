#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/json.h"
#include "fusee/core/text.h"
#include "fusee/plant/rig.h"
#include "label_json.h"

namespace fusee::blind {

namespace {

using SealedJson = nlohmann::json;  // keys in order: the seal is over these bytes

constexpr std::size_t kLargestLabels = 100'000'000;
constexpr std::uint64_t kSalt = 201;
constexpr std::string_view kPrefix = "sha256:";

Label label_of(const SealedJson& j) {
    Label label{j.at("case").get<std::string>(), {}, j.at("in_library").get<bool>(), j.value("doubt", ""), {}};
    if (j.contains("conditions")) {
        const SealedJson& c = j.at("conditions");
        label.conditions = {c.at("linear_springs").get<bool>(), c.at("noise").get<double>(),
                            c.at("experiments").get<std::vector<std::string>>()};
    }
    for (const SealedJson& e : j.at("effects")) {
        LabelEffect effect{e.at("id").get<std::string>(), e.at("side").get<std::string>(), e.at("size").get<double>(), {}};
        for (const auto& [name, value] : e.at("extra").items()) effect.extra.emplace_back(name, value.get<double>());
        label.effects.push_back(std::move(effect));
    }
    return label;
}

std::string bare(std::string_view text) {
    if (text.substr(0, kPrefix.size()) == kPrefix) text.remove_prefix(kPrefix.size());
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r' || text.back() == ' ')) text.remove_suffix(1);
    return std::string(text);
}

}  // namespace

nlohmann::json effects_json(const Label& label) {
    SealedJson effects = SealedJson::array();
    for (const LabelEffect& effect : label.effects) {
        effects.push_back({{"id", effect.id}, {"side", effect.side}, {"size", effect.size}, {"extra", SealedJson::object()}});
        for (const auto& [name, value] : effect.extra) effects.back()["extra"][name] = value;
    }
    return effects;
}

std::string seal_labels(const std::vector<Label>& labels, std::uint64_t seed) {
    plant::Random random(seed, labels.size(), kSalt);
    SealedJson file{
        {"salt", {random.bits(), random.bits(), random.bits(), random.bits()}}, {"seed", seed}, {"labels", SealedJson::array()}};
    for (const Label& label : labels) {
        file["labels"].push_back({{"case", label.case_name}, {"effects", effects_json(label)}, {"in_library", label.in_library}});
        if (label.doubt.empty()) continue;
        const plant::Conditions& c = label.conditions;
        file["labels"].back()["doubt"] = label.doubt;
        file["labels"].back()["conditions"] = {{"linear_springs", c.linear_springs}, {"noise", c.noise}, {"experiments", c.experiments}};
    }
    return core::base64(file.dump()) + "\n";
}

std::string check_seal(const std::filesystem::path& folder, const std::string& hash) {
    std::string sealed = core::read_file(folder / "labels.sealed", kLargestLabels);
    const std::string found = core::sha256_hex(sealed);
    if (found != bare(hash)) throw core::InvalidInput("seal", found, "labels.sealed as it was made, " + bare(hash));
    const std::string written = bare(core::read_file(folder / "seal.txt", kLargestLabels));
    if (written != found) throw core::InvalidInput("seal", "seal.txt names " + written, found);
    return sealed;
}

std::vector<Label> open_seal(const std::filesystem::path& folder, const std::string& hash) {
    const std::string sealed = check_seal(folder, hash);
    std::vector<Label> labels;
    try {
        const SealedJson file = core::parse_json(core::from_base64(sealed), (folder / "labels.sealed").string());
        for (const SealedJson& label : file.at("labels")) labels.push_back(label_of(label));
    } catch (const SealedJson::exception& wrong) {
        throw core::InvalidInput("seal", wrong.what(), "labels as seal_labels writes them");
    }
    return labels;
}

}  // namespace fusee::blind
