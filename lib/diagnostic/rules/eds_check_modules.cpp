// E0895..E0899: types of sub-objects, modules, links between objects, configuration files, domains of an EDS
// or DCF, as checked.
#include "diagnostic/rules/eds_check.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_sub_object_type{
    .code = "E0895",
    .name = "eds-sub-object-type",
    .level = Level::error,
    .summary = "the ObjectType of a sub-object is 7 (VAR), or 2 (DOMAIN)",
    .reference = "CiA 306",
    .why = "A sub-object is one value. Importers that believe ARRAY or RECORD look for values below it.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2001sub1]\n"
        "ObjectType=0x8\n",
    .good =
        "[2001sub1]\n"
        "ObjectType=0x7\n"};
const Rule eds_module{
    .code = "E0896",
    .name = "eds-module",
    .level = Level::warning,
    .summary = "the modules of a modular device are counted, described and list what they bring",
    .reference = "CiA 306",
    .why =
        "SupportedModules counts from 1, each has a ModuleInfo, and its FixedObjects and SubExtends list the "
        "sections that it has. A tool offers no module that it does not find, or loses what it brings.",
    .example = Example::data_sheet_lines,
    .bad =
        "[SupportedModules]\n"
        "NrOfEntries=2\n"
        "[M1ModuleInfo]\n"
        "ProductName=Inputs\n",
    .good =
        "[SupportedModules]\n"
        "NrOfEntries=1\n"
        "[M1ModuleInfo]\n"
        "ProductName=Inputs\n"};
const Rule eds_object_link{
    .code = "E0897",
    .name = "eds-object-link",
    .level = Level::warning,
    .summary = "an object is linked with objects that the device has",
    .reference = "CiA 306",
    .why = "Tools show linked objects together. Here the index is wrong, or an object was forgotten.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2000ObjectLinks]\n"
        "ObjectLinks=1\n"
        "1=0x2002\n",
    .good =
        "[2000ObjectLinks]\n"
        "ObjectLinks=1\n"
        "1=0x2001\n"};
const Rule eds_commissioning_absent{
    .code = "E0898",
    .name = "eds-commissioning-absent",
    .level = Level::warning,
    .summary = "a configuration file says of which node it is",
    .reference = "CiA 306",
    .why =
        "A file that is called .dcf, or names the data sheet it was made from, is the configuration of one "
        "node. Without DeviceComissioning tools ask for the node, or take the file for a data sheet.",
    .example = Example::data_sheet_lines,
    .bad =
        "[FileInfo]\n"
        "LastEDS=pump.eds\n",
    .good =
        "[FileInfo]\n"
        "LastEDS=pump.eds\n"
        "[DeviceComissioning]\n"
        "NodeID=5\n"};
const Rule eds_domain_default{
    .code = "E0899",
    .name = "eds-domain-default",
    .level = Level::note,
    .summary = "a DOMAIN has no number as DefaultValue",
    .reference = "CiA 306",
    .why =
        "What a domain holds is a block of data, not a number. Many files write 0, and nothing is meant by "
        "it: cgw reads it as no default.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2000]\n"
        "ObjectType=0x2\n"
        "DataType=0x000F\n"
        "DefaultValue=0\n"
        "PDOMapping=0\n"
        "[1600sub0]\n"
        "DefaultValue=0x00\n",
    .good =
        "[2000]\n"
        "ObjectType=0x2\n"
        "DataType=0x000F\n"
        "DefaultValue=\n"
        "PDOMapping=0\n"
        "[1600sub0]\n"
        "DefaultValue=0x00\n"};

}  // namespace cgw::diagnostic::rules
