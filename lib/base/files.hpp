// Reading whole files and writing them whole or not at all.
#pragma once

#include <csignal>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/bytes.hpp"
#include "base/result.hpp"

namespace cgw::base {

// All bytes of a file, a pipe, or standard input for "-". More than `limit` bytes is a failure that
// says so; reading stops there, so a hostile stream cannot fill the memory.
Result<std::string> read_file(const std::string& path, std::size_t limit);

// A set of files that appears together: stage() writes beside the target under a temporary name,
// commit() renames. Whatever was staged and not committed is removed again by the destructor. Signals
// that end a program (interrupt, terminate, hang-up) wait until then. One set at a time.
class FileSet {
  public:
    FileSet();
    FileSet(const FileSet&) = delete;
    FileSet& operator=(const FileSet&) = delete;
    ~FileSet();

    // A file whose content is the same already stays untouched, with its time stamp. An existing file keeps
    // its permissions. With `model`, those of another file, a new file gets these, and an existing one can
    // be executed by those who may read it and could execute the model.
    Result<void> stage(const std::filesystem::path& target, std::span<const std::uint8_t> content,
                       std::optional<std::filesystem::perms> model = {});
    Result<void> commit();

  private:
    struct Staged {
        std::filesystem::path temporary;  // empty: a device or a pipe, which is written to, not replaced
        std::filesystem::path target;
        Bytes direct;  // its content
    };
    std::vector<Staged> staged_;
    sigset_t signals_before_{};
};

// `name`, which stands in `file` and is relative to it, seen from where the user is; as it is where `file` is
// standard input ("-").
std::string beside(const std::string& file, const std::string& name);

// Both paths name the same existing file, by whatever links and spellings.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

// One file, whole or not at all; `model` as for FileSet::stage().
Result<void> write_file(const std::filesystem::path& target, std::span<const std::uint8_t> content,
                        std::optional<std::filesystem::perms> model = {});

}  // namespace cgw::base
