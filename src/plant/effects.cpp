#include <algorithm>
#include <array>

#include "effect_kind.h"
#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/plant/case_files.h"

namespace fusee::plant {

namespace {

constexpr std::array<const char*, 3> kEffectSides{"agonist", "antagonist", "both"};

std::vector<std::string> ids_of(const std::vector<EffectKind>& kinds) { return core::each<std::string>(kinds, &EffectKind::id); }

const EffectKind& kind_of(const std::string& id) {
    for (const auto* kinds : {&library_kinds(), &figure_kinds(), &outside_kinds(), &form_blind_kinds(), &engine_kinds()})
        for (const EffectKind& kind : *kinds)
            if (id == kind.id) return kind;
    throw core::InvalidInput("effect", id, "an id of library_ids(), figure_ids(), outside_ids(), form_blind_ids() or engine_ids()");
}

}  // namespace

const std::vector<std::string>& library_ids() {
    static const std::vector<std::string> ids = ids_of(library_kinds());
    return ids;
}

const std::vector<std::string>& figure_ids() {
    static const std::vector<std::string> ids = ids_of(figure_kinds());
    return ids;
}

const std::vector<std::string>& outside_ids() {
    static const std::vector<std::string> ids = ids_of(outside_kinds());
    return ids;
}

const std::vector<std::string>& form_blind_ids() {
    static const std::vector<std::string> ids = ids_of(form_blind_kinds());
    return ids;
}

const std::vector<std::string>& engine_ids() {
    static const std::vector<std::string> ids = ids_of(engine_kinds());
    return ids;
}

double Effect::parameter(const std::string& name) const {
    for (const auto& [key, value] : extra)
        if (key == name) return value;
    throw core::InvalidInput("effect.extra", id, "an effect with the parameter " + name);
}

Effect draw_effect(const std::string& id, const Nominal& nominal, Random& random) {
    const EffectKind& kind = kind_of(id);
    Effect effect{id, "none", 0.0, {}};
    if (kind.to_side != nullptr) effect.side = kEffectSides[random.below(kEffectSides.size())];
    kind.draw(range_of(nominal), random, effect);
    return effect;
}

void apply(const Effect& effect, Truth& truth) {
    const EffectKind& kind = kind_of(effect.id);
    if (kind.to_joint != nullptr) {
        if (effect.side != "none") throw core::InvalidInput("effect.side", effect.side, "none for " + effect.id);
        return kind.to_joint(effect, truth.joint);
    }
    if (std::find(kEffectSides.begin(), kEffectSides.end(), effect.side) == kEffectSides.end())
        throw core::InvalidInput("effect.side", effect.side, "agonist, antagonist or both for " + effect.id);
    for (std::size_t i = 0; i < 2; ++i)
        if (effect.side == kEffectSides[i] || effect.side == kEffectSides[2]) kind.to_side(effect, truth.sides[i]);
}

}  // namespace fusee::plant
