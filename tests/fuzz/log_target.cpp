// Any bytes are read for a log, in two ways of cutting them, decoded in every format and held against a
// plant.
#include "driver/plant.hpp"
#include "driver/traffic_subject.hpp"
#include "fuzz/fuzz.hpp"
#include "media/log_reader.hpp"
#include "traffic/render.hpp"

namespace cgw::fuzz {
namespace {

using Kind = media::LogReader::Kind;

driver::CheckedFile checked(const char* path) {
    driver::CheckedFile file = driver::check_file(path);
    demand(file.valid(), "the sample is valid, and stands where this program was built");
    return file;
}

struct Genset {
    driver::CheckedFile file = checked(CGW_SAMPLES "/genset.toml");
    driver::Plant plant = *driver::Plant::make(file);
    emit::Plant view = plant.view();
    traffic::Subject subject = driver::traffic_subject(file, view);
};

struct Read {
    std::uint64_t frames = 0;
    std::uint64_t faults = 0;
    std::uint64_t passed_over = 0;
    std::vector<diagnostic::Diagnostic> findings;
};

void demand_lines(const std::string& text) {
    demand(text.empty() || text.back() == '\n', "what is printed is whole lines");
}

void print_frame(const traffic::Told& told) {
    for (const traffic::Format& format : traffic::formats()) {
        demand_lines(format.frame(told));
    }
}

Read read(std::string_view bytes, std::size_t piece, bool print) {
    static const Genset genset;
    traffic::Decoder decoder(genset.subject);
    traffic::Audit audit(genset.subject, decoder.owners());
    media::LogReader reader;
    for (;;) {
        const media::LogReader::Item& item = reader.next();
        if (item.kind == Kind::end) {
            break;
        }
        if (item.kind == Kind::hungry) {
            if (bytes.empty()) {
                reader.finish();
            }
            reader.feed(bytes.substr(0, piece));
            bytes.remove_prefix(std::min(piece, bytes.size()));
        } else if (item.kind == Kind::passed_over) {
            audit.pass_over();
        } else if (item.kind == Kind::fault) {
            demand(!item.fault.empty(), "a fault says why");
            audit.take_fault(item.number, item.fault);
        } else if (item.kind == Kind::frame) {
            audit.take({item.number, item.logged.time_us, item.has_time, item.logged.frame});
            const traffic::Meaning meaning = decoder.decode(item.logged.frame);
            demand(!meaning.name.empty(), "a frame has a name");
            if (print) {
                print_frame({item.logged, meaning, item.number, item.has_time, audit.first_us()});
            }
        }
    }
    audit.finish(reader.has_lines());
    const diagnostic::Findings findings = audit.findings("run.log");
    for (const traffic::Format& format : traffic::formats()) {
        demand_lines(format.foot(audit, findings.all()));
    }
    return {audit.frames(), audit.faults(), audit.passed_over(), findings.all()};
}

}  // namespace

void log(Input input) {
    const std::string bytes(input.begin(), input.end());
    const Read whole = read(bytes, bytes.size() + 1, true);
    const Read pieces = read(bytes, 1 + bytes.size() % 61, false);
    demand(whole.frames == pieces.frames && whole.faults == pieces.faults &&
               whole.passed_over == pieces.passed_over && whole.findings.size() == pieces.findings.size(),
           "a log says the same however it is cut");
    demand(whole.findings.size() <= 200, "findings do not grow with the log");
    for (const diagnostic::Diagnostic& finding : whole.findings) {
        demand(finding.rule != nullptr && !finding.message.empty(), "a finding has a rule and a message");
    }
}

}  // namespace cgw::fuzz
