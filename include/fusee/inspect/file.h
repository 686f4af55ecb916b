#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fusee/inspect/body.h"

namespace fusee::inspect {

/// What a file holds as one thing, such as a build item of a 3MF. Its triangles follow those of the item before.
struct Item {
    std::string name;  ///< may be empty
    std::size_t triangles = 0;
};

/// One body of a file: a closed surface with the cavities inside it. Surfaces that are not closed bound nothing: all of an item are one
/// piece.
struct Piece {
    std::string name;  ///< "" if the file has no other; else "body 2", "k_se", "k_se body 2"
    std::size_t item = 0;
    Body body;
    std::vector<std::uint32_t> triangles;  ///< their numbers in the file
};

/// Two bodies that are not apart.
struct Contact {
    enum class Kind { kTouch, kShare, kOverlap };
    std::size_t a = 0, b = 0;  ///< pieces, a < b
    Kind kind = Kind::kTouch;
    std::size_t corners = 0;  ///< kShare: that belong to both
    double area_mm2 = 0.0;    ///< kOverlap: of the surface of one inside the other, the larger one
    solid::Vec3 at_mm{};
};

/// A third-party file: its bodies, and where they meet. Built once, then constant.
class File {
public:
    /// Samples of all bodies together; a body has at most a fifth of them.
    static constexpr std::size_t kSamples = 100'000;

    /// @param items may be empty: one without a name
    /// @param progress called before each stage, with its name
    /// @throws core::InvalidInput as Body; core::Stopped at Ctrl-C
    explicit File(solid::Mesh mesh, std::vector<Item> items = {}, std::size_t samples = kSamples, unsigned jobs = 0,
                  const std::function<void(const std::string&)>& progress = {});

    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }  ///< by their first triangle; at least one
    [[nodiscard]] const std::vector<Item>& items() const { return items_; }
    [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_; }
    [[nodiscard]] const solid::Box& box() const { return box_; }
    [[nodiscard]] std::size_t triangles() const { return triangles_; }

private:
    void find_contacts(const std::vector<std::vector<std::uint32_t>>& corners, unsigned jobs);

    std::vector<Item> items_;
    std::vector<Piece> pieces_;
    std::vector<Contact> contacts_;
    solid::Box box_;
    std::size_t triangles_ = 0;
};

}  // namespace fusee::inspect
