#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fusee::core {

/// Owns a file descriptor.
class Descriptor {
public:
    explicit Descriptor(int value = -1) : value_(value) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }
    [[nodiscard]] int get() const { return value_; }
    [[nodiscard]] int release() { return std::exchange(value_, -1); }
    explicit operator bool() const { return value_ >= 0; }

private:
    int value_;
};

/// An open folder. It stays this folder if its name is moved or replaced; names are relative to it, and no link in them is followed, not
/// even one that appears while fusee runs (openat, O_NOFOLLOW).
class OpenFolder {
public:
    enum class Kind { kNone, kFile, kFolder, kLink, kOther };

    /// A folder that the user names: its links are followed. @throws IoError
    [[nodiscard]] static OpenFolder named(const std::filesystem::path& path);
    /// @param place absolute; a link in it is refused @param shown its name in messages @returns none if it does not exist
    /// @throws IoError naming the part that is a link or no folder
    [[nodiscard]] static std::optional<OpenFolder> find(const std::filesystem::path& place, const std::filesystem::path& shown);
    /// The same; makes what is missing.
    [[nodiscard]] static OpenFolder make(const std::filesystem::path& place, const std::filesystem::path& shown);
    [[nodiscard]] std::optional<OpenFolder> find_inside(const std::filesystem::path& below) const;
    [[nodiscard]] OpenFolder make_inside(const std::filesystem::path& below) const;

    [[nodiscard]] const std::filesystem::path& shown() const { return shown_; }
    [[nodiscard]] int get() const { return folder_.get(); }  ///< for the *at functions
    /// For flock and fsync. @throws IoError
    [[nodiscard]] Descriptor reading() const;
    [[nodiscard]] bool is(const OpenFolder& other) const;
    [[nodiscard]] std::vector<std::string> names() const;  ///< sorted
    [[nodiscard]] Kind kind(const std::string& name) const;
    /// A regular file for reading; never waits for the writer of a pipe. @throws IoError for anything else
    [[nodiscard]] Descriptor open_file(const std::string& name) const;
    /// A new file for appending; no value if the name exists, whatever it is. @throws IoError
    [[nodiscard]] Descriptor create_file(const std::string& name) const;
    /// The bytes of a regular file in pieces. @throws IoError
    void read(const std::string& name, const std::function<void(std::string_view)>& take) const;
    [[nodiscard]] std::string sha256(const std::string& name) const;
    /// @param replaces false: an entry of that name is an error @throws IoError
    void move(const std::string& name, const OpenFolder& to, const std::string& new_name, bool replaces) const;
    void remove(const std::string& name) const;         ///< a file or link. @throws IoError unless it is gone
    bool remove_folder(const std::string& name) const;  ///< @returns false if it is not empty
    void sync() const;                                  ///< flushes the names to the disk. @throws IoError

private:
    OpenFolder(Descriptor folder, std::filesystem::path shown) : folder_(std::move(folder)), shown_(std::move(shown)) {}
    [[nodiscard]] static std::optional<OpenFolder> walk(Descriptor from, std::filesystem::path at, const std::filesystem::path& below,
                                                        bool makes);
    [[nodiscard]] Descriptor copy() const;

    Descriptor folder_;  // O_PATH
    std::filesystem::path shown_;
};

/// Why a write failed, by errno, with the limit that the user can change.
[[nodiscard]] std::string write_failure(int error);

/// Writes all bytes. @returns 0 or errno
[[nodiscard]] int write_all(int file, std::string_view bytes);

/// A file that is written in pieces to a temporary name in the same folder and renamed by `commit`; without commit nothing is left.
/// Inside the staging folder of an OutputFolder no link is followed.
class NewFile {
public:
    explicit NewFile(std::filesystem::path path);  ///< @throws IoError
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    void add(std::string_view bytes);  ///< @throws IoError
    void commit();                     ///< @throws IoError

private:
    void require(int error) const;

    std::filesystem::path path_;
    OpenFolder folder_;
    std::string temporary_;  // empty: renamed
    Descriptor file_;
};

}  // namespace fusee::core
