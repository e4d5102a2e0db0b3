#include "runtime/error_memory.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "base/ascii.hpp"
#include "base/files.hpp"
#include "base/numbers.hpp"
#include "base/utf8.hpp"

namespace cgw::runtime {
namespace {

constexpr std::string_view title = "canopen-gateway error memory ";
constexpr std::int64_t version = 1;
constexpr std::string_view configuration = "configuration ";
constexpr std::string_view last_line = "end";
constexpr std::int64_t most = 255;

// Cuts the first line off; nothing when what is left has no line feed.
std::optional<std::string_view> next_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    return line;
}

// What is wrong with the first line; empty: nothing.
std::string title_fault(std::string_view line) {
    const auto found =
        line.starts_with(title) ? base::parse_integer(line.substr(title.size())) : std::nullopt;
    if (!found) {
        return "this is no error memory of canopen-gateway";
    }
    return *found == version
               ? std::string()
               : fmt::format("error memory of format {}; this program knows {}", *found, version);
}

// False: the line is none of a sentinel that may stand here.
bool take_sentinel(std::string_view line, std::size_t& position, Sentinels& sentinels) {
    const std::size_t blank = line.find(' ');
    if (blank == std::string_view::npos) {
        return false;
    }
    const auto number = base::parse_integer(line.substr(0, blank));
    const auto count = base::parse_integer(line.substr(blank + 1));
    if (!number || !count || *count < 1 || *count > most) {
        return false;
    }
    while (position < sentinels.size() && sentinel_number(position) != *number) {
        ++position;
    }
    if (position == sentinels.size()) {
        return false;
    }
    sentinels[position++] = static_cast<std::uint8_t>(*count);
    return true;
}

}  // namespace

std::string error_memory_text(const Sentinels& sentinels, std::string_view configuration_id) {
    std::string text = fmt::format("{}{}\n{}{}\n", title, version, configuration, configuration_id);
    for (std::size_t position = 0; position < sentinels.size(); ++position) {
        if (sentinels[position] != 0) {
            text += fmt::format("{} {}\n", sentinel_number(position), sentinels[position]);
        }
    }
    return text + std::string(last_line) + "\n";
}

base::Result<Sentinels> parse_error_memory(std::string_view text, const std::string& name) {
    Sentinels sentinels{};
    std::size_t position = 0;
    for (int number = 1;; ++number) {
        const auto fail = [&](std::string_view what) {
            return base::failure(fmt::format("{}:{}: {}", name, number, what));
        };
        const std::optional<std::string_view> line = next_line(text);
        if (number == 1) {
            if (const std::string fault = title_fault(line.value_or("")); !fault.empty()) {
                return fail(fault);
            }
        } else if (!line) {
            return fail("the file is cut off");
        } else if (number == 2) {
            if (!line->starts_with(configuration) ||
                !base::consists_of(line->substr(configuration.size()), base::hexadecimal_digits)) {
                return fail("expected 'configuration' and its id");
            }
        } else if (*line == last_line) {
            return text.empty() ? base::Result<Sentinels>(sentinels) : fail("something follows the end");
        } else if (!take_sentinel(*line, position, sentinels)) {
            return fail(fmt::format("expected a number {}..{}, ascending, and a count 1..{}",
                                    sentinel_number(0), sentinel_number(sentinels.size() - 1), most));
        }
    }
}

base::Result<ErrorMemory> ErrorMemory::open(const std::string& path, std::string configuration_id) {
    ErrorMemory memory(path, std::move(configuration_id));
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::none) {
        return base::failure(fmt::format("cannot read {}: {}", path, error.message()));
    }
    if (!std::filesystem::exists(status)) {
        const std::filesystem::path directory = std::filesystem::path(path).parent_path();
        if (!directory.empty() && !std::filesystem::is_directory(directory, error)) {
            return base::failure(fmt::format("cannot write {}: there is no such directory", path));
        }
        return memory;
    }
    if (!std::filesystem::is_regular_file(status)) {
        return base::failure(fmt::format("{}: an error memory is kept in a regular file", path));
    }
    const base::Result<std::string> text = base::read_file(path, largest_file);
    if (!text) {
        return tl::unexpected(text.error());
    }
    const base::Result<Sentinels> sentinels = parse_error_memory(*text, path);
    if (!sentinels) {
        return tl::unexpected(sentinels.error());
    }
    memory.stored_ = *sentinels;
    memory.written_ = true;
    return memory;
}

base::Result<void> ErrorMemory::keep(const Sentinels& sentinels) {
    if (written_ && sentinels == stored_) {
        return {};
    }
    const std::string text = error_memory_text(sentinels, configuration_id_);
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    if (base::Result<void> written = base::write_file(path_, {bytes, text.size()}); !written) {
        return written;
    }
    stored_ = sentinels;
    written_ = true;
    return {};
}

}  // namespace cgw::runtime
