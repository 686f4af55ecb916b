#include "fields.h"

namespace fusee::gap_case {

namespace {

// The list's rows; `place` is a member of the row.
#define FUSEE_NUMBER(row, name, is_measured, is_required, of, place)                                \
    Field<row> {                                                                                    \
        .column = name, .measured = is_measured, .required = is_required, .quantity = Quantity::of, \
        .get = [](const row& r) { return static_cast<double>(r.place); },                           \
        .set = [](row& r, double value) { r.place = static_cast<decltype(r.place)>(value); }        \
    }
#define FUSEE_INPUT(row, name, of, place) FUSEE_NUMBER(row, name, false, true, of, place)
#define FUSEE_MEASURED(row, name, of, place) FUSEE_NUMBER(row, name, true, true, of, place)

template <class Row>
Field<Row> word(const char* column, std::vector<std::string> words, double (*get)(const Row&), void (*set)(Row&, double)) {
    return {.column = column, .get = get, .set = set, .words = std::move(words)};
}

const std::vector<std::string> kSides{"agonist", "antagonist"};

}  // namespace

template <>
const std::vector<Field<BreakAway>>& fields() {
    using Row = BreakAway;
    static const std::vector<Field<Row>> kFields{
        word<Row>(
            "side", kSides, [](const Row& r) { return r.side == kSides[1] ? 1.0 : 0.0; },
            [](Row& r, double place) { r.side = kSides[static_cast<std::size_t>(place)]; }),
        word<Row>(
            "direction", {"drive", "backdrive"}, [](const Row& r) { return r.backdrive ? 1.0 : 0.0; },
            [](Row& r, double place) { r.backdrive = place == 1.0; }),
        FUSEE_INPUT(Row, "motor_torque_Nm", kPull, motor_torque),
        FUSEE_MEASURED(Row, "load_torque_Nm", kPull, load_torque),
    };
    return kFields;
}

template <>
const std::vector<Field<SpringPull>>& fields() {
    using Row = SpringPull;
    static const std::vector<Field<Row>> kFields{
        word<Row>(
            "spring", {"pe", "se"}, [](const Row& r) { return r.series ? 1.0 : 0.0; },
            [](Row& r, double place) { r.series = place == 1.0; }),
        word<Row>(
            "side", kSides, [](const Row& r) { return static_cast<double>(r.side); },
            [](Row& r, double place) { r.side = place == 1.0 ? Side::kAntagonist : Side::kAgonist; }),
        word<Row>(
            "phase", {"load", "unload"}, [](const Row& r) { return r.load ? 0.0 : 1.0; },
            [](Row& r, double place) { r.load = place == 0.0; }),
        FUSEE_INPUT(Row, "deflection_rad", kDeflection, deflection),
        FUSEE_MEASURED(Row, "torque_Nm", kTorque, torque),
    };
    return kFields;
}

template <>
const std::vector<Field<DeadBandRow>>& fields() {
    using Row = DeadBandRow;
    static const std::vector<Field<Row>> kFields{
        FUSEE_INPUT(Row, "cocontraction_Nm", kPull, cocontraction),
        FUSEE_NUMBER(Row, "repeat", false, false, kCount, repeat),
        FUSEE_NUMBER(Row, "push_torque_Nm", false, false, kJointTorque, push_torque),
        FUSEE_NUMBER(Row, "q_low_rad", true, false, kJointAngle, q_low),
        FUSEE_NUMBER(Row, "q_high_rad", true, false, kJointAngle, q_high),
        FUSEE_NUMBER(Row, "width_rad", true, false, kJointAngle, width),
    };
    return kFields;
}

template <>
const std::vector<Field<StiffnessRow>>& fields() {
    using Row = StiffnessRow;
    static const std::vector<Field<Row>> kFields{
        FUSEE_INPUT(Row, "cocontraction_Nm", kPull, cocontraction),
        word<Row>(
            "phase", {"load+", "unload+", "load-", "unload-"}, [](const Row& r) { return static_cast<double>(r.phase); },
            [](Row& r, double place) { r.phase = static_cast<StiffnessPhase>(place); }),
        FUSEE_INPUT(Row, "joint_torque_Nm", kJointTorque, joint_torque),
        FUSEE_MEASURED(Row, "q_rad", kJointAngle, q),
    };
    return kFields;
}

template <>
const std::vector<Field<CocontractionRow>>& fields() {
    using Row = CocontractionRow;
    static const std::vector<Field<Row>> kFields{
        word<Row>(
            "phase", {"up", "down"}, [](const Row& r) { return r.up ? 0.0 : 1.0; }, [](Row& r, double place) { r.up = place == 0.0; }),
        FUSEE_INPUT(Row, "motor_torque_Nm", kPull, motor_torque),
        FUSEE_MEASURED(Row, "theta_agonist_rad", kCapstanAngle, theta_agonist),
        FUSEE_MEASURED(Row, "theta_antagonist_rad", kCapstanAngle, theta_antagonist),
        FUSEE_MEASURED(Row, "q_rad", kJointAngle, q),
    };
    return kFields;
}

template <>
const std::vector<Field<LogRow>>& fields() {
    using Row = LogRow;
    static const std::vector<Field<Row>> kFields{
        FUSEE_INPUT(Row, "t_s", kTime, time),
        FUSEE_INPUT(Row, "motor_torque_agonist_Nm", kTorque, torque_agonist),
        FUSEE_INPUT(Row, "motor_torque_antagonist_Nm", kTorque, torque_antagonist),
        FUSEE_INPUT(Row, "joint_torque_Nm", kJointTorque, joint_torque),
        FUSEE_MEASURED(Row, "theta_agonist_rad", kCapstanAngle, theta_agonist),
        FUSEE_MEASURED(Row, "theta_antagonist_rad", kCapstanAngle, theta_antagonist),
        FUSEE_MEASURED(Row, "q_rad", kJointAngle, q),
    };
    return kFields;
}

#undef FUSEE_MEASURED
#undef FUSEE_INPUT
#undef FUSEE_NUMBER

}  // namespace fusee::gap_case
