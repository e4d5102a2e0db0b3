#include "base/path_pattern.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace cgw::base {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view any_directories = "**";

bool has_wildcard(std::string_view text) {
    return text.find_first_of("*?[") != std::string_view::npos;
}

std::vector<std::string> names_of(std::string_view pattern) {
    std::vector<std::string> names;
    while (!pattern.empty()) {
        const std::size_t end = std::min(pattern.find('/'), pattern.size());
        const std::string_view name = pattern.substr(0, end);
        // Several in a row say no more than one.
        const bool repeated = !names.empty() && name == any_directories && names.back() == any_directories;
        if (!name.empty() && !repeated) {
            names.emplace_back(name);
        }
        pattern.remove_prefix(std::min(end + 1, pattern.size()));
    }
    return names;
}

class Search {
  public:
    explicit Search(const std::string& pattern) : names_(names_of(pattern)) {
        visit(pattern.starts_with('/') ? "/" : "", 0);
    }

    Result<std::vector<std::string>> result() && {
        if (!failure_.empty()) {
            return failure(std::move(failure_));
        }
        std::sort(found_.begin(), found_.end());
        found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
        return std::move(found_);
    }

  private:
    // `directory` is empty (here) or ends with a slash; the names from `level` on are to be found in it.
    void visit(const std::string& directory, std::size_t level) {
        if (level == names_.size() || !failure_.empty()) {
            return;
        }
        const std::string& name = names_[level];
        if (name == any_directories) {
            visit(directory, level + 1);
            for (const fs::directory_entry& entry : entries(directory)) {
                const std::string child = entry.path().filename().string();
                std::error_code ignored;
                if (!child.starts_with('.') && !entry.is_symlink(ignored) && entry.is_directory(ignored)) {
                    visit(directory + child + "/", level);
                }
            }
        } else if (!has_wildcard(name)) {
            reach(directory + name, level);
        } else {
            for (const fs::directory_entry& entry : entries(directory)) {
                const std::string child = entry.path().filename().string();
                if (::fnmatch(name.c_str(), child.c_str(), FNM_PERIOD) == 0) {
                    reach(directory + child, level);
                }
            }
        }
    }

    void reach(const std::string& path, std::size_t level) {
        std::error_code ignored;
        const fs::file_status status = fs::status(path, ignored);
        if (level + 1 < names_.size()) {
            if (fs::is_directory(status)) {
                visit(path + "/", level + 1);
            }
        } else if (fs::exists(status) && !fs::is_directory(status)) {
            found_.push_back(path);
        }
    }

    std::vector<fs::directory_entry> entries(const std::string& directory) {
        const std::string path = directory.empty() ? "." : directory;
        std::error_code error;
        std::vector<fs::directory_entry> found;
        if (!fs::is_directory(path, error)) {
            return found;
        }
        for (fs::directory_iterator at(path, error); !error && at != fs::directory_iterator();
             at.increment(error)) {
            found.push_back(*at);
        }
        if (error) {
            failure_ = fmt::format("cannot read the directory {}: {}", path, error.message());
        }
        return found;
    }

    std::vector<std::string> names_;
    std::vector<std::string> found_;
    std::string failure_;
};

}  // namespace

bool is_path_pattern(const std::string& path) {
    std::error_code ignored;
    return has_wildcard(path) && !std::filesystem::exists(path, ignored);
}

Result<std::vector<std::string>> files_of_pattern(const std::string& pattern) {
    return Search(pattern).result();
}

}  // namespace cgw::base
