#pragma once
#include <string>
#include <vector>

#include "fusee/pipeline/headline.h"

namespace fusee::report {

using pipeline::condition_verdict, pipeline::ConditionVerdict, pipeline::ExpectedWidth, pipeline::FileErrors, pipeline::Headline,
    pipeline::MadeArm;

/// One figure of a summary: "75.5 to 20.4 deg", and its label. On a card of a page the figure has a short name and at most one line.
struct HeadFigure {
    std::string value, label, name = {}, line = {};
};
/// Lists the figures by importance: dead-band over the co-contractions, arms of the parts as made, joint torque, condition (6).
[[nodiscard]] std::vector<HeadFigure> head_figures(const Headline& headline, const FileErrors& files);

/// "Condition (6) holds from 0.85 Nm to 1.5 Nm, by 0.012 at least: ..."
[[nodiscard]] std::string condition_text(const actuator::ConditionSummary& condition);

}  // namespace fusee::report
