#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/frames_input.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/plant.hpp"
#include "driver/traffic_subject.hpp"
#include "media/log_file.hpp"
#include "traffic/render.hpp"
#include "traffic/typed_frame.hpp"

namespace cgw::cli {
namespace {

std::vector<Word> decode_format_words() {
    std::vector<Word> words;
    for (const traffic::Format& format : traffic::formats()) {
        words.push_back({format.name, format.summary});
    }
    return words;
}

constexpr Option decode_options[] = {
    {.names = "WHAT",
     .summary = "a log, - for standard input; or a frame: 0x181 A0 0F",
     .required = true,
     .repeats = true,
     .completes = Completes::files},
    {.names = "--config",
     .value = "FILE",
     .summary = "parameter file of the plant",
     .required = true,
     .completes = Completes::files},
    {.names = "--audit", .summary = "of a log only what was counted and found, no frames"},
    {.names = "--interface", .value = "NAME", .summary = "of a log only the frames of this interface: can0"},
    {.names = "--format",
     .value = "FORMAT",
     .summary = "form of the output",
     .default_value = "text",
     .words = decode_format_words},
    color_option,
};

constexpr std::string_view decode_details =
    "A log is candump -L, what candump shows on the screen, or pcap of link type 227;\n"
    "the format is found by itself, the size does not matter. Each frame is told:\n"
    "PDOs in engineering units, NMT, SYNC, EMCY, SDO with objects and abort texts,\n"
    "heartbeat and node guarding. At the end the log is held against the plant:\n"
    "frames that are missing, unexpected, of wrong length or too late. Findings are\n"
    "on standard error, with --format json in the last line.\n\n"
    "A frame is typed as 0x181 A0 0F, 181h A00F or 181#A00F.\n\n"
    "Exit code 0; 1 when FILE has errors or the log has findings of that level, 3\n"
    "when one of them cannot be read.\n";

const traffic::Format& format_of(const Arguments& arguments) {
    const auto all = traffic::formats();
    return *std::find_if(all.begin(), all.end(), [&](const traffic::Format& format) {
        return format.name == arguments.value("--format");
    });
}

int decode_typed(const Arguments& arguments, const traffic::Subject& subject) {
    diagnostic::Findings findings;
    const media::LoggedFrame logged{.time_us = 0,
                                    .interface_name = "",
                                    .frame = traffic::read_typed_frame(arguments.values("WHAT"), findings)};
    if (findings.has_errors()) {
        report_arguments(findings, arguments);
        return exit_findings;
    }
    traffic::Decoder decoder(subject);
    const traffic::Meaning meaning = decoder.decode(logged.frame);
    const traffic::Format& format = format_of(arguments);
    const std::string text =
        format.name == "text"
            ? traffic::explain_frame(logged.frame, meaning)
            : format.head(subject) +
                  format.frame(
                      {.logged = logged, .meaning = meaning, .number = 0, .has_time = false, .start_us = 0});
    return print(text) ? exit_fine : exit_environment;
}

// One pass over a log. Lines wait in a buffer, since writing each of them would take most of the time.
class LogDecoder {
  public:
    struct Wanted {
        bool frames = true;          // and not only the audit
        std::string interface_name;  // "": all
    };

    LogDecoder(const traffic::Subject& subject, const traffic::Format& format, Wanted wanted)
        : decoder_(subject), audit_(subject, decoder_.owners()), format_(format), wanted_(std::move(wanted)) {
        text_ = format.head(subject);
    }

    // Exit code.
    int run(media::LogFile& file) {
        media::LogReader reader;
        for (;;) {
            const media::LogReader::Item& item = reader.next();
            if (item.kind == media::LogReader::Kind::end) {
                break;
            }
            if (item.kind == media::LogReader::Kind::hungry) {
                if (const base::Result<void> fed = file.feed(reader); !fed) {
                    print_error(fed.error().message);
                    return exit_environment;
                }
                if (!flush(largest_buffer)) {
                    return exit_environment;
                }
            }
            take(item);
        }
        audit_.finish(reader.has_lines());
        return exit_fine;
    }

    const traffic::Audit& audit() const { return audit_; }
    // Interfaces of which frames are in the log, where none is of the wanted one; "".
    std::string other_interfaces() const {
        return audit_.frames() == 0 ? fmt::format("{}", fmt::join(others_, ", ")) : "";
    }
    bool end(std::span<const diagnostic::Diagnostic> findings) {
        text_ += format_.foot(audit_, findings);
        return flush(0);
    }

  private:
    static constexpr std::size_t largest_buffer = std::size_t{64} << 10;

    bool flush(std::size_t most) {
        if (text_.size() <= most) {
            return true;
        }
        const bool fine = print(text_);
        text_.clear();
        return fine;
    }

    bool is_wanted(const media::LogReader::Item& item) {
        constexpr std::size_t most_others = 8;
        const std::string& name = item.logged.interface_name;
        const bool wanted = wanted_.interface_name.empty() || name == wanted_.interface_name;
        if (!wanted && others_.size() < most_others) {
            others_.insert(name);
        }
        return wanted;
    }

    void take(const media::LogReader::Item& item) {
        if (item.kind == media::LogReader::Kind::passed_over) {
            audit_.pass_over();
        } else if (item.kind == media::LogReader::Kind::fault) {
            audit_.take_fault(item.number, item.fault);
        } else if (item.kind == media::LogReader::Kind::frame && is_wanted(item)) {
            audit_.take({item.number, item.logged.time_us, item.has_time, item.logged.frame});
            if (wanted_.frames) {
                const traffic::Meaning meaning = decoder_.decode(item.logged.frame);
                text_ += format_.frame({.logged = item.logged,
                                        .meaning = meaning,
                                        .number = item.number,
                                        .has_time = item.has_time,
                                        .start_us = audit_.first_us()});
            }
        }
    }

    traffic::Decoder decoder_;
    traffic::Audit audit_;
    const traffic::Format& format_;
    Wanted wanted_;
    std::set<std::string> others_;  // interfaces whose frames are not wanted, some of them
    std::string text_;
};

int decode_log(const Arguments& arguments, const traffic::Subject& subject) {
    const std::string& path = arguments.values("WHAT").front();
    base::Result<media::LogFile> file = media::LogFile::open(path);
    if (!file) {
        print_error(file.error().message);
        return exit_environment;
    }
    const traffic::Format& format = format_of(arguments);
    LogDecoder log(subject, format, {!arguments.given("--audit"), arguments.value("--interface")});
    if (const int exit_code = log.run(*file); exit_code != exit_fine) {
        return exit_code;
    }
    const diagnostic::Findings findings = log.audit().findings(path);
    if (const std::string others = log.other_interfaces(); !others.empty()) {
        print_error(fmt::format("no frame is of interface {}; this log has frames of {}",
                                arguments.value("--interface"), others));
    }
    if (!log.end(findings.all())) {
        return exit_environment;
    }
    if (format.name != "json" && !findings.all().empty()) {
        report_findings({.files = {{path, findings.all()}},
                         .sources = {},
                         .color = use_color(arguments, stderr),
                         .verdicts = false});
    }
    return findings.has_errors() ? exit_findings : exit_fine;
}

int run_decode(const Arguments& arguments) {
    const std::vector<std::string>& what = arguments.values("WHAT");
    const bool typed = traffic::begins_frame(what.front());
    if (!typed && what.size() != 1) {
        throw UsageError("one log, or one frame as 0x181 A0 0F");
    }
    if (typed && arguments.given("--audit")) {
        throw UsageError("--audit: a single frame is no log");
    }
    if (what.front() == "-" && arguments.value("--config") == "-") {
        throw UsageError("standard input (-) can be read only once");
    }
    int exit_code = exit_fine;
    const std::optional<FramesInput> input = read_frames(arguments, "--config", exit_code);
    if (!input) {
        return exit_code;
    }
    const auto plant = driver::Plant::make(input->file);
    if (!plant) {
        throw UsageError(plant.error().message);
    }
    const emit::Plant view = plant->view();
    const traffic::Subject subject = driver::traffic_subject(input->file, view);
    return typed ? decode_typed(arguments, subject) : decode_log(arguments, subject);
}

}  // namespace

const Verb decode_verb = {"decode", "say what frames mean, one typed in or those of a log", decode_options,
                          run_decode, decode_details};

}  // namespace cgw::cli
