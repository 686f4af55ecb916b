#pragma once
#include <string>
#include <vector>

#include "fusee/inference/model.h"
#include "fusee/simulator/case.h"

namespace fusee::simulator {

/// What may be wrong where a column enters or leaves the model.
struct Port {
    enum class Kind { kOffset, kScale, kDelay, kDrift, kDeadZone };
    Kind kind = Kind::kOffset;
    std::string column;
    bool output = false;       ///< else an input
    inference::Effect effect;  ///< "port.COLUMN.offset"
};

/// "begin_rad", "elbow_begin_rad": where a run begins, of which a simulator takes the first row. It is no signal that enters it.
[[nodiscard]] bool is_begin(const std::string& name);
/// Those of every input but the time, and of every output. A column that never changes has none.
[[nodiscard]] std::vector<Port> ports_of(const Case& of_case);

/// Does what the port says to one column of a run. @param time of the run; null: it has none
void apply_port(Port::Kind kind, double size, const std::vector<double>* time, std::vector<double>& column);

}  // namespace fusee::simulator
