#include "xdd/reader.hpp"

#include <fmt/format.h>

#include <array>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/xdd.hpp"
#include "xdd/reading.hpp"

namespace cgw::xdd {
namespace {

namespace rules = diagnostic::rules;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view container = "ISO15745ProfileContainer";

// What else ends in .xdd or .xdc, or looks like it, and how it is told apart.
struct Foreign {
    std::string_view sign;
    std::string_view message;
};

// Words of a text that is no XML.
constexpr std::array foreign_texts{
    Foreign{"get_ports",
            "this is a file of FPGA design constraints (.xdc of Xilinx), no CANopen configuration"},
    Foreign{"create_clock",
            "this is a file of FPGA design constraints (.xdc of Xilinx), no CANopen configuration"},
    Foreign{"set_property",
            "this is a file of FPGA design constraints (.xdc of Xilinx), no CANopen configuration"},
    Foreign{"[FileInfo]", "this is an EDS or DCF, no XML"},
};

// The root element, or the name space of it.
constexpr std::array foreign_roots{
    Foreign{"http://www.ethernet-powerlink.org",
            "this is a device description for Ethernet POWERLINK, not for CANopen"},
    Foreign{"EtherCATInfo", "this is a device description for EtherCAT (ESI), not for CANopen"},
    Foreign{"OpenEDSProject", "this is a project of several devices; each of them needs a file of its own"},
};

// With a byte order mark, or < in two bytes at the beginning.
bool is_utf_16(std::string_view text) {
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
           text.starts_with(std::string_view("<\0", 2)) || text.starts_with(std::string_view("\0<", 2));
}

// False after a finding.
bool judge_bytes(std::string_view text, const std::string& path, diagnostic::Findings& findings) {
    const auto refuse = [&](std::string_view message) {
        findings.report({&rules::xdd_text, std::string(message), {path, {}}});
        return false;
    };
    if (text.size() > largest_text) {
        return refuse(fmt::format("the file has more than {} MiB", largest_text / 1024 / 1024));
    }
    if (is_utf_16(text)) {
        return refuse("the file is UTF-16; save it as UTF-8");
    }
    if (text.find('\0') != std::string_view::npos) {
        return refuse("a byte 0 stands in the text");
    }
    if (!is_xml(text)) {
        for (const Foreign& foreign : foreign_texts) {
            if (text.find(foreign.sign) != std::string_view::npos) {
                return refuse(foreign.message);
            }
        }
        return refuse("the file is no XML: nothing stands between < and > at its beginning");
    }
    return true;
}

// False after a finding.
bool judge_root(Source& source) {
    const pugi::xml_node root = source.root();
    const std::string_view name = local_name(root.name());
    for (const Foreign& foreign : foreign_roots) {
        if (name == foreign.sign || foreign.sign == root.attribute("xmlns").value()) {
            source.report(rules::xdd_root, root, std::string(foreign.message));
            return false;
        }
    }
    if (Source::child(Source::child(root, "Profile"), "ProfileBody")) {
        source.report(rules::xdd_root, root,
                      "this is a device description of maxon's own form, not of CiA 311");
        return false;
    }
    if (name != container) {
        source.report(
            rules::xdd_root, root,
            fmt::format("the file begins with <{}>; a device description of CiA 311 begins with <{}>",
                        base::printable(name), container));
        return false;
    }
    return true;
}

// The first of each kind.
Parts parts_of(pugi::xml_node root) {
    Parts parts;
    Source::each_child(root, "ISO15745Profile", [&parts](pugi::xml_node profile) {
        const pugi::xml_node body = Source::child(profile, "ProfileBody");
        const pugi::xml_node layers = Source::child(body, "ApplicationLayers");
        if (layers && !parts.network_body) {
            parts.network_body = body;
            parts.objects = Source::child(layers, "CANopenObjectList");
        } else if (body && !layers && !parts.device_body) {
            parts.device_body = body;
        }
    });
    return parts;
}

}  // namespace

bool is_xml(std::string_view text) {
    text.remove_prefix(text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
    if (is_utf_16(text)) {
        const bool has_mark = text.front() != '<' && text.front() != '\0';
        const std::string_view first = text.substr(has_mark ? 2 : 0, 2);
        return first.find('<') != std::string_view::npos;
    }
    return base::trimmed(text, " \t\r\n").starts_with('<');
}

Sheet read(std::string_view text, const std::string& path, diagnostic::Findings& findings) {
    Sheet sheet;
    if (!judge_bytes(text, path, findings)) {
        return sheet;
    }
    text.remove_prefix(text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
    Source source(text, path, findings);
    if (!source.parse() || !judge_root(source)) {
        return sheet;
    }
    const Parts parts = parts_of(source.root());
    if (!parts.objects) {
        source.report(rules::xdd_root, source.root(),
                      "the file has no CANopenObjectList: it describes no object of a CANopen device");
        return sheet;
    }
    Parameters parameters(source, parts.device_body);
    sheet.dictionary.objects = read_objects(source, parts, parameters);
    read_information(source, parts, sheet.dictionary);
    sheet.commissioning = read_commissioning(source, parts);
    sheet.unread = find_unread(source.root());
    source.finish();
    return sheet;
}

}  // namespace cgw::xdd
