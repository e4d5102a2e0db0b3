// The parts of annotate(), one source file each. Private to the room.
#pragma once

#include "inspect/annotation.hpp"
#include "inspect/outline.hpp"

namespace cgw::inspect {

using Groups = std::vector<Group>;

// The fields of one record of `size` bytes at `at`; those that the file does not hold whole are bytes that
// are marked as cut off, those behind the known ones bytes of a later minor.
Group record_group(const Outline& outline, const Record& record, std::optional<std::size_t> position,
                   std::size_t at, std::size_t size);

Item plain_bytes(std::size_t offset, std::size_t size, std::string name, std::string meaning);

// header_items.cpp: header and directory, judged.
void header_groups(const Outline& outline, Groups& groups);

// section_items.cpp: the records of a section, or its plain bytes: values by object, texts by label.
void section_groups(const Outline& outline, const Extent& extent, Groups& groups);

// judgement.cpp: what is wrong between fields; `where` is the section that the verifier refuses.
void judge_sections(const Outline& outline, Groups& groups);

}  // namespace cgw::inspect
