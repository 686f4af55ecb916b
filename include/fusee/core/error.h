#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fusee::core {

/// The input of a command is wrong: a value, several values or a file. The app ends with exit code 2.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// One wrong value: names the field, the value found and what is allowed.
class InvalidInput : public InputError {
public:
    /// @param field place of the value, e.g. "rig.gear_friction" or "springs.csv:12: torque_Nm"
    InvalidInput(std::string field, std::string value, std::string allowed);

    [[nodiscard]] const std::string& field() const { return field_; }
    [[nodiscard]] const std::string& value() const { return value_; }
    [[nodiscard]] const std::string& allowed() const { return allowed_; }

private:
    std::string field_, value_, allowed_;
};

/// Several wrong values from one reading. `what()` has their number and one line each.
class InvalidInputs : public InputError {
public:
    /// @pre at least one
    explicit InvalidInputs(std::vector<InvalidInput> all);
    [[nodiscard]] const std::vector<InvalidInput>& all() const { return all_; }

private:
    std::vector<InvalidInput> all_;
};

/// Collects the mistakes of one reading, so that a user sees all of them at once.
class Mistakes {
public:
    /// Runs `read` and keeps the InvalidInput or InvalidInputs that it throws. @returns whether it threw neither
    template <class Read>
    bool collect(const Read& read) {
        try {
            read();
            return true;
        } catch (const InvalidInput& e) {
            all_.push_back(e);
        } catch (const InvalidInputs& e) {
            all_.insert(all_.end(), e.all().begin(), e.all().end());
        }
        return false;
    }
    void add(InvalidInput mistake) { all_.push_back(std::move(mistake)); }
    [[nodiscard]] bool empty() const { return all_.empty(); }
    [[nodiscard]] const std::vector<InvalidInput>& all() const { return all_; }
    /// @throws InvalidInput if there is one mistake, InvalidInputs if there are more
    void throw_if_any() const;

private:
    std::vector<InvalidInput> all_;
};

/// A file could not be read, written or understood.
class IoError : public InputError {
public:
    IoError(const std::string& path, const std::string& why);
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] const std::string& why() const { return why_; }

private:
    std::string path_, why_;
};

/// Where a value stands, as the field of an InvalidInput says: "p.toml:3:7: cable.diameter_mm".
struct Location {
    std::string file;                  ///< "": none
    std::size_t line = 0, column = 0;  ///< from 1; 0: none
    std::string field;                 ///< the rest: key, column, option
};
[[nodiscard]] Location location_of(const std::string& field);

/// @throws InvalidInput unless `value` is finite and within [low, high]
double require_within(const std::string& field, double value, double low, double high, const std::string& unit = "");
/// @throws InvalidInput unless `value` is finite and above 0
double require_positive(const std::string& field, double value, const std::string& unit = "");

}  // namespace fusee::core
