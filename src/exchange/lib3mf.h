#pragma once
#include <Model/COM/NMR_DLLInterfaces.h>

#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>

#include "fusee/solid/mesh.h"

/// lib3mf's C interface with owners and errors, for the files of this module that write and read 3MF.
namespace fusee::exchange {

/// lib3mf promises nothing about threads; one at a time costs little beside the work around it.
[[nodiscard]] std::mutex& library_mutex();

/// An object of lib3mf, released at the end of its scope. Every kind of handle is the same void** to the C interface.
class Handle {
public:
    Handle() = default;
    ~Handle() {
        if (object_ != nullptr) NMR::lib3mf_release(object_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    [[nodiscard]] NMR::PLib3MFBase* get() const { return object_; }
    [[nodiscard]] NMR::PLib3MFBase** out() { return &object_; }

private:
    NMR::PLib3MFBase* object_ = nullptr;
};

/// @throws IoError with lib3mf's own message, asked from the object on which the call was made
void require(LIB3MFRESULT result, const Handle& object, const std::filesystem::path& path, const char* doing);

/// An RFC 9562 version 8 UUID made from a hash: the same input names the same object.
[[nodiscard]] std::string uuid_from(std::string_view text);

/// Text that XML 1.0 can hold: what is no UTF-8 and what are control characters becomes U+FFFD.
[[nodiscard]] std::string xml_text(std::string_view text);

/// Sets the object's name. lib3mf escapes it.
void set_name(const Handle& object, const std::string& name, const std::filesystem::path& path);
/// Sets the model's metadata "Description", escaped: lib3mf writes metadata as they are.
void set_description(const Handle& model, const std::string& text, const std::filesystem::path& path);

/// The model as the bytes of a 3MF file. @throws IoError
[[nodiscard]] std::string bytes_of(const Handle& model, const std::filesystem::path& path);

/// A mesh object's points and triangles, in the model's unit. @throws IoError, also if it holds no triangles
[[nodiscard]] solid::Mesh take_mesh(const Handle& object, const std::filesystem::path& path);

}  // namespace fusee::exchange
