#include "base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace cgw::base {
namespace {

// Closes on every path; close errors matter only after writing, where release() is used first.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ > STDIN_FILENO) {
            ::close(number_);
        }
    }
    int get() const { return number_; }
    int release() {
        const int number = number_;
        number_ = -1;
        return number;
    }

  private:
    int number_;
};

std::string reason() {
    return std::strerror(errno);
}

Result<std::string> read_all(int descriptor, const std::string& name, std::size_t limit) {
    std::string content;
    std::array<char, 65536> buffer{};
    for (;;) {
        const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            return failure(fmt::format("cannot read {}: {}", name, reason()));
        }
        if (count == 0) {
            return content;
        }
        content.append(buffer.data(), static_cast<std::size_t>(count));
        if (content.size() > limit) {
            return tl::unexpected<Failure>(
                Failure{fmt::format("cannot read {}: it is larger than {} bytes", name, limit), true});
        }
    }
}

bool write_all(int descriptor, std::span<const std::uint8_t> content) {
    while (!content.empty()) {
        const ssize_t count = ::write(descriptor, content.data(), content.size());
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            return false;
        }
        content = content.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

bool holds_already(const std::filesystem::path& target, std::span<const std::uint8_t> content) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(target, error) ||
        std::filesystem::file_size(target, error) != content.size()) {
        return false;
    }
    const Result<std::string> present = read_file(target.string(), content.size());
    return present && std::equal(present->begin(), present->end(), content.begin(), content.end(),
                                 [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

// A new file beside the target, so that the later rename stays on one file system.
Result<void> write_temporary(const std::filesystem::path& temporary, const std::filesystem::path& target,
                             std::span<const std::uint8_t> content, std::optional<mode_t> exact) {
    constexpr mode_t usual = S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;  // umask narrows it
    constexpr mode_t permissions = 0777;
    // Never more open than it is to become, not even while it is written.
    const mode_t mode = exact ? *exact & permissions : usual;
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    if (file.get() < 0) {
        return failure(fmt::format("cannot write {}: {}", target.string(), reason()));
    }
    if (exact) {
        ::fchmod(file.get(), *exact);  // what the umask took away; file systems without permissions refuse
    }
    const bool written = write_all(file.get(), content);
    const int write_error = errno;
    const bool closed = ::close(file.release()) == 0;
    if (written && closed) {
        return {};
    }
    const std::string why = std::strerror(written ? errno : write_error);
    ::unlink(temporary.c_str());
    return failure(fmt::format("cannot write {}: {}", target.string(), why));
}

// What a file is to have beside its content; nullopt: a new file like any other.
std::optional<mode_t> mode_of(const std::filesystem::path& target,
                              std::optional<std::filesystem::perms> model) {
    constexpr mode_t every_bit = 07777, permissions = 0777, readable = 0444;
    std::optional<mode_t> given;
    if (model) {
        given = static_cast<mode_t>(*model) & permissions;
    }
    struct stat old {};
    if (::stat(target.c_str(), &old) != 0) {
        return given;
    }
    const mode_t kept = old.st_mode & every_bit;  // a private file stays private
    const mode_t readers = (kept & readable) >> 2U;
    return kept | (given.value_or(0) & readers);
}

// A device or a pipe is written to, not replaced: --depfile /dev/null, -o /dev/full, a named pipe.
bool is_special(const std::filesystem::path& target) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(target, error);
    return std::filesystem::exists(status) && std::filesystem::is_other(status);
}

Result<void> write_special(const std::filesystem::path& target, std::span<const std::uint8_t> content) {
    Descriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.get() < 0 || !write_all(file.get(), content) || ::close(file.release()) != 0) {
        return failure(fmt::format("cannot write {}: {}", target.string(), reason()));
    }
    return {};
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::size_t limit) {
    if (path == "-") {
        return read_all(STDIN_FILENO, "standard input", limit);
    }
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0) {
        return failure(fmt::format("cannot read {}: {}", path, reason()));
    }
    return read_all(file.get(), path, limit);
}

FileSet::FileSet() {
    sigset_t ending;
    ::sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        ::sigaddset(&ending, signal);
    }
    ::pthread_sigmask(SIG_BLOCK, &ending, &signals_before_);
}

FileSet::~FileSet() {
    for (const Staged& staged : staged_) {
        ::unlink(staged.temporary.c_str());
    }
    ::pthread_sigmask(SIG_SETMASK, &signals_before_, nullptr);
}

Result<void> FileSet::stage(const std::filesystem::path& target, std::span<const std::uint8_t> content,
                            std::optional<std::filesystem::perms> model) {
    std::error_code error;
    if (std::filesystem::is_directory(target, error)) {
        return failure(fmt::format("cannot write {}: it is a directory", target.string()));
    }
    if (is_special(target)) {
        staged_.push_back({{}, target, Bytes(content.begin(), content.end())});
        return {};
    }
    if (holds_already(target, content)) {
        return {};
    }
    // Writing through a link keeps the link: the file it points to is replaced.
    const std::filesystem::path real = std::filesystem::is_symlink(target, error)
                                           ? std::filesystem::weakly_canonical(target, error)
                                           : target;
    const std::filesystem::path temporary =
        real.parent_path() /
        fmt::format(".{}.{}.{}.tmp", real.filename().string(), ::getpid(), staged_.size());
    if (Result<void> written = write_temporary(temporary, target, content, mode_of(real, model)); !written) {
        return written;
    }
    staged_.push_back({temporary, real, {}});
    return {};
}

Result<void> FileSet::commit() {
    for (const Staged& staged : staged_) {
        if (staged.temporary.empty()) {
            if (Result<void> written = write_special(staged.target, staged.direct); !written) {
                return written;
            }
        }
    }
    std::erase_if(staged_, [](const Staged& staged) { return staged.temporary.empty(); });
    std::string replaced;  // a rename rarely fails after staging; then the user must know what is new
    while (!staged_.empty()) {
        const Staged& next = staged_.back();
        if (::rename(next.temporary.c_str(), next.target.c_str()) != 0) {
            const std::string why = reason();
            return failure(fmt::format("cannot write {}: {}{}{}", next.target.string(), why,
                                       replaced.empty() ? "" : "; written already:", replaced));
        }
        replaced += " " + next.target.string();
        staged_.pop_back();
    }
    return {};
}

std::string beside(const std::string& file, const std::string& name) {
    return file == "-" ? name : (std::filesystem::path(file).parent_path() / name).string();
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code error;
    return std::filesystem::equivalent(a, b, error) && !error;
}

Result<void> write_file(const std::filesystem::path& target, std::span<const std::uint8_t> content,
                        std::optional<std::filesystem::perms> model) {
    FileSet files;
    if (Result<void> staged = files.stage(target, content, model); !staged) {
        return staged;
    }
    return files.commit();
}

}  // namespace cgw::base
