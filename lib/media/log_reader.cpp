#include "media/log_reader.hpp"

#include <fmt/format.h>

#include "media/candump.hpp"
#include "media/candump_screen.hpp"

namespace cgw::media {
namespace {

constexpr std::size_t magic_size = 4;

}  // namespace

void LogReader::feed(std::string_view bytes) {
    buffer_.erase(0, at_);
    at_ = 0;
    buffer_ += bytes;
}

const LogReader::Item& LogReader::next() {
    item_.kind = Kind::hungry;
    if (given_up_) {
        item_.kind = Kind::end;
        return item_;
    }
    if (format_ == Format::unknown) {
        find_format();
    }
    if (format_ == Format::text) {
        next_line();
    } else if (format_ == Format::pcap) {
        next_record();
    }
    return item_;
}

void LogReader::set_fault(std::string text) {
    item_.kind = Kind::fault;
    item_.number = number_;
    item_.fault = std::move(text);
}

void LogReader::give_up(std::string text) {
    set_fault(std::move(text));
    given_up_ = true;
    buffer_.clear();
    at_ = 0;
}

void LogReader::find_format() {
    if (rest().size() < magic_size && !finished_) {
        return;
    }
    if (!is_pcap(rest())) {
        format_ = Format::text;
        return;
    }
    if (rest().size() < pcap_header_size && !finished_) {
        return;
    }
    format_ = Format::pcap;
    const base::Result<PcapKind> kind = read_pcap_header(rest());
    if (!kind) {
        give_up(kind.error().message);
        return;
    }
    kind_ = *kind;
    at_ += pcap_header_size;
}

void LogReader::next_line() {
    const std::size_t end = rest().find('\n');
    if (end == std::string_view::npos && !finished_) {
        if (rest().size() > longest_line) {  // its contents are not needed any more
            in_long_line_ = true;
            at_ = buffer_.size();
        }
        return;
    }
    if (end == std::string_view::npos && rest().empty() && !in_long_line_) {
        item_.kind = Kind::end;
        return;
    }
    const std::string_view line = rest().substr(0, end);
    at_ += end == std::string_view::npos ? line.size() : end + 1;
    ++number_;
    if (in_long_line_ || line.size() > longest_line) {
        in_long_line_ = false;
        set_fault(fmt::format("a line of more than {} bytes is no frame", longest_line));
        return;
    }
    read_line(line);
}

void LogReader::read_line(std::string_view line) {
    ReadLine read = read_candump_line(line);
    item_.has_time = true;
    if (read.kind == LineKind::wrong) {
        ScreenLine screen = read_screen_line(line);
        item_.has_time = screen.has_time;
        read = std::move(screen.line);
    }
    item_.number = number_;
    switch (read.kind) {
        case LineKind::frame:
            item_.kind = Kind::frame;
            item_.logged = std::move(read.logged);
            break;
        case LineKind::passed_over:
            item_.kind = Kind::passed_over;
            break;
        case LineKind::blank:
            item_.kind = Kind::blank;
            break;
        case LineKind::wrong:
            set_fault("this is no frame as candump writes it");
            break;
    }
}

void LogReader::next_record() {
    if (given_up_) {
        return;  // its header was wrong, and has been told
    }
    if (rest().size() < pcap_record_header_size) {
        if (finished_ && rest().empty()) {
            item_.kind = Kind::end;
        } else if (finished_) {
            ++number_;
            give_up("the file is cut off");
        }
        return;
    }
    const PcapRecordHeader header = read_pcap_record_header(rest(), kind_);
    if (!header.size_possible) {
        ++number_;
        give_up("the length of this record is not possible, and what follows cannot be found");
        return;
    }
    if (rest().size() < pcap_record_header_size + header.size) {
        if (finished_) {
            ++number_;
            give_up("the file is cut off");
        }
        return;
    }
    ++number_;
    item_.number = number_;
    const std::string_view record = rest().substr(pcap_record_header_size, header.size);
    item_.logged = {.time_us = header.time_us, .interface_name = std::string(pcap_interface), .frame = {}};
    const PcapRecord read = read_pcap_frame(record, item_.logged.frame);
    at_ += pcap_record_header_size + header.size;
    item_.has_time = true;
    item_.kind = read == PcapRecord::frame ? Kind::frame : Kind::passed_over;
    if (read == PcapRecord::wrong) {
        set_fault("this record holds no CAN frame");
    } else if (!header.time_possible) {
        set_fault("the time of this record is not possible");
    }
}

}  // namespace cgw::media
