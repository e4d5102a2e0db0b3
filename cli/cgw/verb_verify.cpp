#include <fmt/format.h>

#include <algorithm>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_file.hpp"
#include "driver/plant.hpp"
#include "driver/prove.hpp"
#include "live/report.hpp"
#include "media/open_channel.hpp"

namespace cgw::cli {
namespace {

std::vector<Word> verify_format_words() {
    std::vector<Word> words;
    for (const live::Format& format : live::formats()) {
        words.push_back({format.name, format.summary});
    }
    return words;
}

constexpr Option verify_options[] = {
    parameter_file_option,
    {.names = "--live",
     .value = "CHANNEL",
     .summary = "the CAN bus of the running device: hub:, socketcan:, slcan:"},
    {.names = "--read-only", .summary = "--live: do not try whether the device refuses to be written"},
    {.names = "--eds",
     .value = "PATH",
     .summary = "EDS, DCF, XDD or XDC to compare with FILE",
     .repeats = true,
     .completes = Completes::files},
    {.names = "--image",
     .value = "PATH",
     .summary = "configuration image to compare with FILE",
     .repeats = true,
     .completes = Completes::files},
    {.names = "--dbc",
     .value = "PATH",
     .summary = "CAN database to compare with FILE",
     .repeats = true,
     .completes = Completes::files},
    {.names = "--format",
     .value = "FORMAT",
     .summary = "form of the report",
     .default_value = "human",
     .words = verify_format_words},
    color_option,
};

constexpr std::string_view verify_details =
    "With --eds, --image and --dbc: whether these files still describe the device\n"
    "that FILE makes, object by object; the last step before they are handed out. An\n"
    "image is compared in every field that a gateway reads, a database in every\n"
    "message and signal, and an EDS or DCF must pass cgw eds check --strict. Who\n"
    "wrote the files, and when, does not count. Exit code 0 when all are the same, 1\n"
    "when one differs or has errors, 3 when one cannot be read.\n\n"
    "With --live: reads every object of the configured EDS from the gateway with the\n"
    "node-ID of FILE (427) and compares: who it is, values, lengths, what must be\n"
    "refused, and what must not exist. Values that change while the device runs are\n"
    "compared by type only. Nothing in the device is changed: what is written is the\n"
    "value just read, and the device must refuse it. No NMT command is sent; one\n"
    "request is on the bus at a time.\n"
    "CHANNEL is hub:HOST:PORT[/BUS], socketcan:INTERFACE or slcan:TTY@KBIT.\n"
    "Exit code 0 when the device has the configuration of FILE, 1 when it differs or\n"
    "is another device, 3 when it cannot be reached or does not answer to the end.\n";

int exit_code_of_ending(const live::Result& result) {
    switch (result.ending) {
        case live::Ending::complete:
            return result.differences.empty() ? exit_fine : exit_findings;
        case live::Ending::other_device:
            return exit_findings;
        case live::Ending::none:
        case live::Ending::silent:
        case live::Ending::unsendable:
        case live::Ending::interrupted:
            break;
    }
    return exit_environment;
}

// A line that is overwritten and vanishes at the end; nothing where standard error is no terminal.
class Progress {
  public:
    void show(const live::Verification& verification) const {
        if (shown_) {
            fmt::print(stderr, "\r{} of {} questions, {} differences\x1b[K", verification.result().asked,
                       verification.plan().size(), verification.result().differences.size());
            std::fflush(stderr);
        }
    }
    void clear() const {
        if (shown_) {
            fmt::print(stderr, "\r\x1b[K");
        }
    }

  private:
    bool shown_ = is_terminal(stderr);
};

int verify_live(const Arguments& arguments) {
    if (const std::string mistake = media::channel_mistake(arguments.value("--live")); !mistake.empty()) {
        throw UsageError("--live: " + mistake);
    }
    auto channel = media::open_channel(arguments.value("--live"));
    if (!channel) {
        print_error(channel.error().message);
        return exit_environment;
    }
    const driver::CheckedFile file = driver::check_file(arguments.value("FILE"));
    if (!file.valid()) {
        report_findings(file, use_color(arguments, stderr));
        return exit_code_of(file);
    }
    const auto plant = driver::Plant::make(file);
    if (!plant) {
        throw UsageError(plant.error().message);
    }
    const live::Subject subject{.path = file.path,
                                .configuration_id = driver::short_configuration_id(file.settings),
                                .channel = arguments.value("--live"),
                                .wrote = !arguments.given("--read-only"),
                                .settings = file.settings,
                                .configuration = file.configuration,
                                .catalogue = *file.catalogue};
    const std::uint8_t node_id = file.configuration.node_id;
    live::Verification verification(live::plan(plant->view().dictionary, node_id, {.write = subject.wrote}),
                                    node_id, **channel);
    const Progress progress;
    const live::Connection connection =
        live::run(**channel, verification, [&](const live::Verification& now) { progress.show(now); });
    progress.clear();
    for (const live::Format& format : live::formats()) {
        if (format.name == arguments.value("--format") &&
            !print(format.render(subject, verification, connection))) {
            return exit_environment;
        }
    }
    return exit_code_of_ending(verification.result());
}

int verify_files(const Arguments& arguments) {
    const driver::Artefacts artefacts{arguments.values("--eds"), arguments.values("--image"),
                                      arguments.values("--dbc")};
    const bool color = use_color(arguments, stderr);
    const driver::CheckedFile file = driver::check_file(arguments.value("FILE"));
    if (!file.valid()) {
        report_findings(file, color);
        return exit_code_of(file);
    }
    const auto plant = driver::Plant::make(file);
    if (!plant) {
        throw UsageError(plant.error().message);
    }
    const driver::Proofs proofs = driver::prove(plant->view(), artefacts);
    if (!proofs.reports.empty()) {
        report_findings({proofs.reports, proofs.sources, color, {}});
    }
    const proof::Subject subject{file.path, driver::short_configuration_id(file.settings),
                                 file.configuration.node_id};
    for (const proof::Format& format : proof::formats()) {
        if (format.name == arguments.value("--format") && !proofs.all.empty() &&
            !print(format.render(subject, proofs.all))) {
            return exit_environment;
        }
    }
    const int of_files = proofs.unreadable ? exit_environment : proofs.has_errors ? exit_findings : exit_fine;
    return worse(of_files, proof::all_same(proofs.all) ? exit_fine : exit_findings);
}

int run_verify(const Arguments& arguments) {
    int from_stdin = arguments.value("FILE") == "-" ? 1 : 0;
    bool files = false;
    for (const std::string_view key : {"--eds", "--image", "--dbc"}) {
        const std::vector<std::string>& paths = arguments.values(key);
        files = files || !paths.empty();
        from_stdin += static_cast<int>(std::count(paths.begin(), paths.end(), "-"));
    }
    if (files == arguments.given("--live")) {
        throw UsageError("compare FILE with files (--eds, --image, --dbc) or with a running device (--live)");
    }
    if (files && arguments.given("--read-only")) {
        throw UsageError("--read-only goes with --live");
    }
    if (from_stdin > 1) {
        throw UsageError("standard input (-) can be read only once");
    }
    return files ? verify_files(arguments) : verify_live(arguments);
}

}  // namespace

const Verb verify_verb = {"verify", "compare artefacts or a running gateway with a parameter file",
                          verify_options, run_verify, verify_details};

}  // namespace cgw::cli
