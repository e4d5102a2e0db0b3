/* A configuration image read in plain C: C99 and C++, no heap, no library, one file. docs/image-format.md
   describes the format, lib/image/layout.hpp is its source; a test holds this header to both.

   For boot loaders, service tools and test benches. A firmware that runs the gateway uses the C++ verifier,
   cgw::image::Image::open(). This one checks, with the same codes:
     - everything about header, size, CRC-32, directory, padding, presence and record sizes: codes 1 to 9 are
   given exactly where the C++ verifier gives them;
     - that every object's value lies in the value block (11) and every label's text in the strings (13), so
   that nothing outside the image is ever read. It does not check the values of records, nor records against
   each other: code 10, code 12 and the rest of 11 and 13 come from the C++ verifier only.

   Everything is read from the caller's bytes, which must stay as they are; any alignment, any byte order.
   Functions with a position want one below the count; those that find something return 1, else 0 and leave
   what they were to fill in as it is.

   Of an area that is larger than the image, such as a region of flash memory, cgw_image_in() says how much of
   it is to be opened. */
#ifndef CGW_IMAGE_H
#define CGW_IMAGE_H

#include <stddef.h>
#include <stdint.h>

/* Casts in C are old-style casts in C++; there is no other way to write both. */
#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#endif

/* Refusal codes; stable, a later version only adds. */
enum cgw_image_status {
    CGW_IMAGE_OK = 0,
    CGW_IMAGE_TOO_SMALL = 1,
    CGW_IMAGE_TOO_LARGE = 2,
    CGW_IMAGE_BAD_MAGIC = 3,
    CGW_IMAGE_UNSUPPORTED_MAJOR = 4,
    CGW_IMAGE_BAD_HEADER_SIZE = 5, /* or reserved header bytes in use */
    CGW_IMAGE_SIZE_MISMATCH = 6,
    CGW_IMAGE_BAD_CRC = 7,
    CGW_IMAGE_BAD_DIRECTORY = 8,
    CGW_IMAGE_SECTION_MISSING = 9,
    CGW_IMAGE_BAD_SECTION = 10, /* of the C++ verifier */
    CGW_IMAGE_BAD_OBJECT_TABLE = 11,
    CGW_IMAGE_BAD_MAPPING = 12, /* of the C++ verifier */
    CGW_IMAGE_BAD_LABEL = 13
};

/* Where everything stands, in bytes. */
enum cgw_image_layout {
    CGW_IMAGE_FORMAT_MAJOR = 1,
    CGW_IMAGE_FORMAT_MINOR = 0,
    CGW_IMAGE_MINIMUM_SIZE = 68,
    CGW_IMAGE_MAXIMUM_SIZE = 65536,
    CGW_IMAGE_CRC_SIZE = 4,

    CGW_IMAGE_HEADER_MAGIC = 0,
    CGW_IMAGE_HEADER_FORMAT_MAJOR = 4,
    CGW_IMAGE_HEADER_FORMAT_MINOR = 6,
    CGW_IMAGE_HEADER_HEADER_SIZE = 8,
    CGW_IMAGE_HEADER_SECTION_COUNT = 10,
    CGW_IMAGE_HEADER_TOTAL_SIZE = 12,
    CGW_IMAGE_HEADER_CONFIGURATION_ID = 16,
    CGW_IMAGE_HEADER_CONFIGURATION_ID_SIZE = 32,
    CGW_IMAGE_HEADER_TOOL_VERSION = 48,
    CGW_IMAGE_HEADER_RESERVED = 54,
    CGW_IMAGE_HEADER_SIZE = 64,

    CGW_IMAGE_DIRECTORY_ID = 0,
    CGW_IMAGE_DIRECTORY_RECORD_SIZE = 2,
    CGW_IMAGE_DIRECTORY_OFFSET = 4,
    CGW_IMAGE_DIRECTORY_SIZE = 8,
    CGW_IMAGE_DIRECTORY_ENTRY_SIZE = 12,

    CGW_IMAGE_IDENTITY_VENDOR = 0,
    CGW_IMAGE_IDENTITY_PRODUCT = 4,
    CGW_IMAGE_IDENTITY_REVISION = 8,
    CGW_IMAGE_IDENTITY_SERIAL = 12,
    CGW_IMAGE_IDENTITY_SIZE = 16,

    CGW_IMAGE_BUS_OWN_NODE = 0,
    CGW_IMAGE_BUS_PEER_NODE = 1,
    CGW_IMAGE_BUS_MANUAL_TIMING = 2,
    CGW_IMAGE_BUS_BIT_RATE_KBIT = 4,
    CGW_IMAGE_BUS_REGISTERS = 6,
    CGW_IMAGE_BUS_START_UP_DELAY_MS = 12,
    CGW_IMAGE_BUS_SIZE = 16,
    CGW_IMAGE_BUS_COUNT = 2,

    CGW_IMAGE_GOVERNOR_OWN_NODE = 0,
    CGW_IMAGE_GOVERNOR_GATEWAY_NODE = 1,
    CGW_IMAGE_GOVERNOR_MANUAL_TIMING = 2,
    CGW_IMAGE_GOVERNOR_SEND_ERRORS = 3,
    CGW_IMAGE_GOVERNOR_BIT_RATE_KBIT = 4,
    CGW_IMAGE_GOVERNOR_REGISTERS = 6,
    CGW_IMAGE_GOVERNOR_START_UP_DELAY_MS = 12,
    CGW_IMAGE_GOVERNOR_MAIN_CYCLE_US = 16,
    CGW_IMAGE_GOVERNOR_SEND_STATUS = 20,
    CGW_IMAGE_GOVERNOR_SIZE = 24,

    CGW_IMAGE_HEARTBEAT_PRODUCER_US = 0,
    CGW_IMAGE_HEARTBEAT_CONSUMER_US = 4,
    CGW_IMAGE_HEARTBEAT_CONSUMER_NODE = 8,
    CGW_IMAGE_HEARTBEAT_SIZE = 12,

    CGW_IMAGE_PDO_DIRECTION = 0,
    CGW_IMAGE_PDO_NUMBER = 1,
    CGW_IMAGE_PDO_ACTIVE = 2,
    CGW_IMAGE_PDO_COB_ID_SOURCE = 3,
    CGW_IMAGE_PDO_COB_ID = 4,
    CGW_IMAGE_PDO_WORD_COUNT = 6,
    CGW_IMAGE_PDO_TRANSMISSION_TYPE = 7,
    CGW_IMAGE_PDO_EFFECTIVE_US = 8,
    CGW_IMAGE_PDO_ASKED_MS = 12,
    CGW_IMAGE_PDO_CYCLES = 14,
    CGW_IMAGE_PDO_MAPPING = 16,
    CGW_IMAGE_PDO_PARAMETERS = 32,
    CGW_IMAGE_PDO_SIZE = 40,
    CGW_IMAGE_PDO_COUNT = 20,

    CGW_IMAGE_OBJECT_INDEX = 0,
    CGW_IMAGE_OBJECT_SUB_INDEX = 2,
    CGW_IMAGE_OBJECT_TYPE = 3,
    CGW_IMAGE_OBJECT_RIGHTS = 4,
    CGW_IMAGE_OBJECT_OFFSET = 6,
    CGW_IMAGE_OBJECT_SIZE = 8,

    CGW_IMAGE_SWITCH_NUMBER = 0,
    CGW_IMAGE_SWITCH_BIT = 2,
    CGW_IMAGE_SWITCH_LOW_ACTIVE = 3,
    CGW_IMAGE_SWITCH_SIZE = 4,

    CGW_IMAGE_SENSOR_NUMBER = 0,
    CGW_IMAGE_SENSOR_CHANNEL = 2,
    CGW_IMAGE_SENSOR_SIZE = 4,

    CGW_IMAGE_SIGNAL_NUMBER = 0,
    CGW_IMAGE_SIGNAL_WIDTH = 2,
    CGW_IMAGE_SIGNAL_IS_SIGNED = 3,
    CGW_IMAGE_SIGNAL_INTERNAL_MINIMUM = 4,
    CGW_IMAGE_SIGNAL_INTERNAL_MAXIMUM = 6,
    CGW_IMAGE_SIGNAL_SIZE = 8,

    CGW_IMAGE_LABEL_NUMBER = 0,
    CGW_IMAGE_LABEL_NAME_LENGTH = 2,
    CGW_IMAGE_LABEL_UNIT_LENGTH = 3,
    CGW_IMAGE_LABEL_NAME_OFFSET = 4,
    CGW_IMAGE_LABEL_UNIT_OFFSET = 8,
    CGW_IMAGE_LABEL_HAS_SCALING = 12,
    CGW_IMAGE_LABEL_EXTERNAL_MINIMUM = 16,
    CGW_IMAGE_LABEL_EXTERNAL_MAXIMUM = 24,
    CGW_IMAGE_LABEL_SIZE = 32
};

enum cgw_image_section {
    CGW_IMAGE_IDENTITY = 1,
    CGW_IMAGE_BUSES = 2,
    CGW_IMAGE_GOVERNOR = 3,
    CGW_IMAGE_HEARTBEAT = 4,
    CGW_IMAGE_PDOS = 5,
    CGW_IMAGE_OBJECTS = 6,
    CGW_IMAGE_OBJECT_VALUES = 7,
    CGW_IMAGE_SWITCHES = 8,
    CGW_IMAGE_SENSORS = 9,
    CGW_IMAGE_SIGNALS = 10,
    CGW_IMAGE_LABELS = 11, /* may be missing, with the strings */
    CGW_IMAGE_STRINGS = 12,
    CGW_IMAGE_MODEL = 13, /* may be missing; only where labels are */
    CGW_IMAGE_SECTION_IDS = 14
};

typedef struct {
    const uint8_t* data;  /* NULL: the section is not there */
    uint32_t size;        /* bytes */
    uint32_t record_size; /* at least the layout's; longer in a later minor */
} cgw_image_records;

typedef struct {
    const uint8_t* bytes;
    uint32_t size;
    cgw_image_records sections[CGW_IMAGE_SECTION_IDS]; /* by id; [0] is unused */
} cgw_image;

typedef struct {
    uint32_t vendor, product, revision, serial; /* object 1018h */
} cgw_image_identity;

typedef struct {
    uint8_t own_node, peer_node, manual_timing;
    uint16_t bit_rate_kbit;
    uint8_t registers[6];
    uint32_t start_up_delay_ms;
} cgw_image_bus;

typedef struct {
    uint8_t own_node, gateway_node, manual_timing, send_errors, send_status;
    uint16_t bit_rate_kbit;
    uint8_t registers[5];
    uint32_t start_up_delay_ms, main_cycle_us;
} cgw_image_governor;

typedef struct {
    uint32_t producer_us, consumer_us; /* 0: off */
    uint8_t consumer_node;
} cgw_image_heartbeat;

typedef struct {
    uint16_t index;
    uint8_t sub_index, bits;
    uint16_t parameter; /* 0: none */
} cgw_image_word;

typedef struct {
    uint8_t receive, number, active, cob_id_from_parameter;
    uint16_t cob_id;
    uint8_t transmission_type, word_count;
    uint32_t effective_us;
    uint16_t asked_ms, cycles;
    cgw_image_word words[4];
} cgw_image_pdo;

typedef struct {
    uint16_t index;
    uint8_t sub_index, type, access, flags, length; /* length of the value in bytes */
    uint16_t offset;                                /* in the value block */
    uint32_t value;                                 /* at start; its `length` low bytes */
} cgw_image_object;

typedef struct {
    uint16_t number;
    uint8_t bit, low_active;
} cgw_image_switch;

typedef struct {
    uint16_t number;
    uint8_t channel;
} cgw_image_sensor;

typedef struct {
    uint16_t number;
    uint8_t width, is_signed;
    int32_t internal_minimum, internal_maximum;
} cgw_image_signal;

typedef struct {
    uint16_t number;         /* 0: the title of the parameter file */
    const char *name, *unit; /* UTF-8, not terminated */
    uint8_t name_length, unit_length, has_scaling;
    double external_minimum, external_maximum;
} cgw_image_label;

/* ---- bytes ---- */

static inline uint16_t cgw_image_u16(const uint8_t* from) {
    return (uint16_t)(from[0] | (unsigned)from[1] << 8);
}

static inline uint32_t cgw_image_u32(const uint8_t* from) {
    return cgw_image_u16(from) | (uint32_t)cgw_image_u16(from + 2) << 16;
}

static inline double cgw_image_f64(const uint8_t* from) {
    const uint64_t bits = cgw_image_u32(from) | (uint64_t)cgw_image_u32(from + 4) << 32;
    double value = 0;
    size_t i;
    for (i = 0; i < sizeof value; ++i) {
        ((unsigned char*)&value)[i] = ((const unsigned char*)&bits)[i];
    }
    return value;
}

static inline void cgw_image_copy(uint8_t* to, const uint8_t* from, unsigned count) {
    while (count-- != 0) {
        *to++ = *from++;
    }
}

static inline int cgw_image_all_are(const uint8_t* from, size_t count, uint8_t value) {
    while (count-- != 0) {
        if (*from++ != value) {
            return 0;
        }
    }
    return 1;
}

static inline int cgw_image_all_zero(const uint8_t* from, uint32_t count) {
    return cgw_image_all_are(from, count, 0);
}

/* IEEE 802.3. */
static inline uint32_t cgw_image_crc32(const uint8_t* from, uint32_t count) {
    uint32_t crc = 0xFFFFFFFFu;
    while (count-- != 0) {
        int bit;
        crc ^= *from++;
        for (bit = 0; bit < 8; ++bit) {
            crc = (crc & 1u) != 0 ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
        }
    }
    return ~crc;
}

/* ---- verification ---- */

static inline uint16_t cgw_image_format_major(const cgw_image* image) {
    return cgw_image_u16(image->bytes + CGW_IMAGE_HEADER_FORMAT_MAJOR);
}

static inline uint16_t cgw_image_format_minor(const cgw_image* image) {
    return cgw_image_u16(image->bytes + CGW_IMAGE_HEADER_FORMAT_MINOR);
}

/* True when every byte of an image of this minor is known here: nothing may be added then. */
static inline int cgw_image_known_minor(const cgw_image* image) {
    return cgw_image_format_minor(image) <= CGW_IMAGE_FORMAT_MINOR;
}

static inline uint32_t cgw_image_align(uint32_t offset) {
    return (offset + 3u) & ~3u;
}

/* Where the directory ends. */
static inline uint32_t cgw_image_directory_end(const cgw_image* image) {
    return cgw_image_u16(image->bytes + CGW_IMAGE_HEADER_HEADER_SIZE) +
           (uint32_t)cgw_image_u16(image->bytes + CGW_IMAGE_HEADER_SECTION_COUNT) *
               CGW_IMAGE_DIRECTORY_ENTRY_SIZE;
}

static inline unsigned cgw_image_check_header(const cgw_image* image) {
    const uint8_t* bytes = image->bytes;
    const int known = cgw_image_known_minor(image);
    const uint16_t header_size = cgw_image_u16(bytes + CGW_IMAGE_HEADER_HEADER_SIZE);
    if (bytes[0] != 'C' || bytes[1] != 'G' || bytes[2] != 'W' || bytes[3] != 'I') {
        return CGW_IMAGE_BAD_MAGIC;
    }
    if (cgw_image_format_major(image) != CGW_IMAGE_FORMAT_MAJOR) {
        return CGW_IMAGE_UNSUPPORTED_MAJOR;
    }
    if (header_size < CGW_IMAGE_HEADER_SIZE || header_size % 4 != 0 ||
        (known && header_size != CGW_IMAGE_HEADER_SIZE)) {
        return CGW_IMAGE_BAD_HEADER_SIZE;
    }
    if (cgw_image_u32(bytes + CGW_IMAGE_HEADER_TOTAL_SIZE) != image->size) {
        return CGW_IMAGE_SIZE_MISMATCH;
    }
    if (cgw_image_directory_end(image) > image->size - CGW_IMAGE_CRC_SIZE) {
        return CGW_IMAGE_BAD_DIRECTORY;
    }
    if (known && !cgw_image_all_zero(bytes + CGW_IMAGE_HEADER_RESERVED,
                                     CGW_IMAGE_HEADER_SIZE - CGW_IMAGE_HEADER_RESERVED)) {
        return CGW_IMAGE_BAD_HEADER_SIZE;
    }
    return CGW_IMAGE_OK;
}

typedef struct {
    uint16_t record_size, record_count; /* count 0: any number */
    uint8_t required, bytes;            /* bytes: not records, no later minor can lengthen them */
} cgw_image_rule;

static inline cgw_image_rule cgw_image_rule_of(unsigned id) {
    static const cgw_image_rule rules[CGW_IMAGE_SECTION_IDS] = {
        {0, 0, 0, 0},
        {CGW_IMAGE_IDENTITY_SIZE, 1, 1, 0},
        {CGW_IMAGE_BUS_SIZE, CGW_IMAGE_BUS_COUNT, 1, 0},
        {CGW_IMAGE_GOVERNOR_SIZE, 1, 1, 0},
        {CGW_IMAGE_HEARTBEAT_SIZE, 1, 1, 0},
        {CGW_IMAGE_PDO_SIZE, CGW_IMAGE_PDO_COUNT, 1, 0},
        {CGW_IMAGE_OBJECT_SIZE, 0, 1, 0},
        {1, 0, 1, 1},
        {CGW_IMAGE_SWITCH_SIZE, 0, 1, 0},
        {CGW_IMAGE_SENSOR_SIZE, 0, 1, 0},
        {CGW_IMAGE_SIGNAL_SIZE, 0, 1, 0},
        {CGW_IMAGE_LABEL_SIZE, 0, 0, 0},
        {1, 0, 0, 1},
        {1, 0, 0, 1}};
    return rules[id];
}

/* `end` is where the section before ended, and becomes where this one ends; never past the CRC. */
static inline unsigned cgw_image_check_entry(cgw_image* image, const uint8_t* entry, uint32_t* end) {
    const unsigned id = cgw_image_u16(entry + CGW_IMAGE_DIRECTORY_ID);
    const uint32_t record_size = cgw_image_u16(entry + CGW_IMAGE_DIRECTORY_RECORD_SIZE);
    const uint32_t offset = cgw_image_u32(entry + CGW_IMAGE_DIRECTORY_OFFSET);
    const uint32_t size = cgw_image_u32(entry + CGW_IMAGE_DIRECTORY_SIZE);
    const uint32_t room = image->size - CGW_IMAGE_CRC_SIZE;
    const int known = cgw_image_known_minor(image);
    cgw_image_rule rule;
    if (offset != cgw_image_align(*end) || offset > room || size > room - offset || record_size == 0 ||
        size % record_size != 0 || !cgw_image_all_zero(image->bytes + *end, offset - *end)) {
        return CGW_IMAGE_BAD_DIRECTORY;
    }
    *end = offset + size;
    if (id >= CGW_IMAGE_SECTION_IDS) {
        return known ? CGW_IMAGE_BAD_DIRECTORY : CGW_IMAGE_OK;
    }
    rule = cgw_image_rule_of(id);
    if (record_size < rule.record_size || ((known || rule.bytes) && record_size != rule.record_size) ||
        (rule.record_count != 0 && size / record_size != rule.record_count)) {
        return CGW_IMAGE_BAD_DIRECTORY;
    }
    image->sections[id].data = image->bytes + offset;
    image->sections[id].size = size;
    image->sections[id].record_size = record_size;
    return CGW_IMAGE_OK;
}

static inline unsigned cgw_image_check_directory(cgw_image* image) {
    const uint16_t count = cgw_image_u16(image->bytes + CGW_IMAGE_HEADER_SECTION_COUNT);
    const uint8_t* entry = image->bytes + cgw_image_u16(image->bytes + CGW_IMAGE_HEADER_HEADER_SIZE);
    const uint32_t room = image->size - CGW_IMAGE_CRC_SIZE;
    uint32_t end = cgw_image_directory_end(image);
    unsigned last_id = 0, i;
    for (i = 0; i < count; ++i, entry += CGW_IMAGE_DIRECTORY_ENTRY_SIZE) {
        const unsigned id = cgw_image_u16(entry + CGW_IMAGE_DIRECTORY_ID);
        if (id <= last_id || cgw_image_check_entry(image, entry, &end) != CGW_IMAGE_OK) {
            return CGW_IMAGE_BAD_DIRECTORY;
        }
        last_id = id;
    }
    return cgw_image_align(end) == room && cgw_image_all_zero(image->bytes + end, room - end)
               ? CGW_IMAGE_OK
               : CGW_IMAGE_BAD_DIRECTORY;
}

static inline unsigned cgw_image_check_presence(const cgw_image* image) {
    const int labels = image->sections[CGW_IMAGE_LABELS].data != NULL;
    const int strings = image->sections[CGW_IMAGE_STRINGS].data != NULL;
    const int model = image->sections[CGW_IMAGE_MODEL].data != NULL;
    unsigned id;
    for (id = 1; id < CGW_IMAGE_SECTION_IDS; ++id) {
        if (cgw_image_rule_of(id).required && image->sections[id].data == NULL) {
            return CGW_IMAGE_SECTION_MISSING;
        }
    }
    return labels == strings && (labels || !model) ? CGW_IMAGE_OK : CGW_IMAGE_SECTION_MISSING;
}

/* Number of records; 0 for a section that is not there. */
static inline uint32_t cgw_image_count(const cgw_image* image, unsigned section) {
    const cgw_image_records* records = &image->sections[section];
    return records->data == NULL ? 0 : records->size / records->record_size;
}

/* Bytes of one record. */
static inline const uint8_t* cgw_image_record(const cgw_image* image, unsigned section, uint32_t position) {
    return image->sections[section].data + position * image->sections[section].record_size;
}

/* Bytes of a value of that CiA 301 data type; 0 for types that no object has. */
static inline uint8_t cgw_image_type_size(uint8_t type) {
    static const uint8_t sizes[8] = {0, 1, 1, 2, 4, 1, 2, 4};
    return type < sizeof sizes ? sizes[type] : (uint8_t)0;
}

static inline int cgw_image_inside(const cgw_image* image, unsigned section, uint32_t offset,
                                   uint32_t length) {
    const uint32_t size = image->sections[section].size;
    return offset <= size && length <= size - offset;
}

static inline unsigned cgw_image_check_references(const cgw_image* image) {
    uint32_t i;
    for (i = 0; i < cgw_image_count(image, CGW_IMAGE_OBJECTS); ++i) {
        const uint8_t* record = cgw_image_record(image, CGW_IMAGE_OBJECTS, i);
        const uint8_t length = cgw_image_type_size(record[CGW_IMAGE_OBJECT_TYPE]);
        const uint16_t offset = cgw_image_u16(record + CGW_IMAGE_OBJECT_OFFSET);
        if (length == 0 || !cgw_image_inside(image, CGW_IMAGE_OBJECT_VALUES, offset, length)) {
            return CGW_IMAGE_BAD_OBJECT_TABLE;
        }
    }
    for (i = 0; i < cgw_image_count(image, CGW_IMAGE_LABELS); ++i) {
        const uint8_t* record = cgw_image_record(image, CGW_IMAGE_LABELS, i);
        if (!cgw_image_inside(image, CGW_IMAGE_STRINGS, cgw_image_u32(record + CGW_IMAGE_LABEL_NAME_OFFSET),
                              record[CGW_IMAGE_LABEL_NAME_LENGTH]) ||
            !cgw_image_inside(image, CGW_IMAGE_STRINGS, cgw_image_u32(record + CGW_IMAGE_LABEL_UNIT_OFFSET),
                              record[CGW_IMAGE_LABEL_UNIT_LENGTH])) {
            return CGW_IMAGE_BAD_LABEL;
        }
    }
    return CGW_IMAGE_OK;
}

/* Of an area that is reserved for an image, how many bytes from its beginning cgw_image_open() is to judge,
   as image_in() of lib/image/area.hpp: as many as the image says it has. 0 where the area is erased, all FFh
   or all 00h, which open refuses with CGW_IMAGE_TOO_SMALL; where the beginning is damaged as many as an image
   can have, which it refuses with the fitting code. */
static inline size_t cgw_image_in(const void* area, size_t size) {
    const uint8_t* bytes = (const uint8_t*)area;
    if (size >= CGW_IMAGE_MINIMUM_SIZE && bytes[0] == 'C' && bytes[1] == 'G' && bytes[2] == 'W' &&
        bytes[3] == 'I') {
        const uint32_t stated = cgw_image_u32(bytes + CGW_IMAGE_HEADER_TOTAL_SIZE);
        const uint16_t header_size = cgw_image_u16(bytes + CGW_IMAGE_HEADER_HEADER_SIZE);
        if (stated >= CGW_IMAGE_MINIMUM_SIZE && stated <= CGW_IMAGE_MAXIMUM_SIZE && stated <= size &&
            header_size >= CGW_IMAGE_HEADER_SIZE && header_size < stated) {
            return stated;
        }
    }
    if (cgw_image_all_are(bytes, size, 0xFF) || cgw_image_all_are(bytes, size, 0x00)) {
        return 0;
    }
    return size < CGW_IMAGE_MAXIMUM_SIZE ? size : (size_t)CGW_IMAGE_MAXIMUM_SIZE;
}

/* Checks what the top of this file says; returns a code of cgw_image_status. On anything but CGW_IMAGE_OK the
   image may not be asked anything. */
static inline unsigned cgw_image_open(cgw_image* image, const void* bytes, size_t size) {
    unsigned status, id;
    if (size < CGW_IMAGE_MINIMUM_SIZE) {
        return CGW_IMAGE_TOO_SMALL;
    }
    if (size > CGW_IMAGE_MAXIMUM_SIZE) {
        return CGW_IMAGE_TOO_LARGE;
    }
    image->bytes = (const uint8_t*)bytes;
    image->size = (uint32_t)size;
    for (id = 0; id < CGW_IMAGE_SECTION_IDS; ++id) {
        image->sections[id].data = NULL;
        image->sections[id].size = 0;
        image->sections[id].record_size = 1;
    }
    status = cgw_image_check_header(image);
    if (status == CGW_IMAGE_OK) {
        const uint32_t body = image->size - CGW_IMAGE_CRC_SIZE;
        status = cgw_image_crc32(image->bytes, body) == cgw_image_u32(image->bytes + body)
                     ? CGW_IMAGE_OK
                     : CGW_IMAGE_BAD_CRC;
    }
    status = status == CGW_IMAGE_OK ? cgw_image_check_directory(image) : status;
    status = status == CGW_IMAGE_OK ? cgw_image_check_presence(image) : status;
    return status == CGW_IMAGE_OK ? cgw_image_check_references(image) : status;
}

/* ---- what an opened image holds ---- */

static inline const uint8_t* cgw_image_configuration_id(const cgw_image* image) { /* 32 bytes */
    return image->bytes + CGW_IMAGE_HEADER_CONFIGURATION_ID;
}

static inline uint16_t cgw_image_tool_version(const cgw_image* image,
                                              unsigned part) { /* 0 major, 1 minor, 2 patch */
    return cgw_image_u16(image->bytes + CGW_IMAGE_HEADER_TOOL_VERSION + 2 * part);
}

static inline uint32_t cgw_image_crc(const cgw_image* image) {
    return cgw_image_u32(image->bytes + image->size - CGW_IMAGE_CRC_SIZE);
}

static inline cgw_image_identity cgw_image_get_identity(const cgw_image* image) {
    const uint8_t* record = cgw_image_record(image, CGW_IMAGE_IDENTITY, 0);
    cgw_image_identity result;
    result.vendor = cgw_image_u32(record + CGW_IMAGE_IDENTITY_VENDOR);
    result.product = cgw_image_u32(record + CGW_IMAGE_IDENTITY_PRODUCT);
    result.revision = cgw_image_u32(record + CGW_IMAGE_IDENTITY_REVISION);
    result.serial = cgw_image_u32(record + CGW_IMAGE_IDENTITY_SERIAL);
    return result;
}

/* position 0: CAN1, to the governor; 1: CAN2, CANopen */
static inline cgw_image_bus cgw_image_get_bus(const cgw_image* image, unsigned position) {
    const uint8_t* record = cgw_image_record(image, CGW_IMAGE_BUSES, position);
    cgw_image_bus result;
    result.own_node = record[CGW_IMAGE_BUS_OWN_NODE];
    result.peer_node = record[CGW_IMAGE_BUS_PEER_NODE];
    result.manual_timing = record[CGW_IMAGE_BUS_MANUAL_TIMING];
    result.bit_rate_kbit = cgw_image_u16(record + CGW_IMAGE_BUS_BIT_RATE_KBIT);
    cgw_image_copy(result.registers, record + CGW_IMAGE_BUS_REGISTERS, sizeof result.registers);
    result.start_up_delay_ms = cgw_image_u32(record + CGW_IMAGE_BUS_START_UP_DELAY_MS);
    return result;
}

static inline cgw_image_governor cgw_image_get_governor(const cgw_image* image) {
    const uint8_t* record = cgw_image_record(image, CGW_IMAGE_GOVERNOR, 0);
    cgw_image_governor result;
    result.own_node = record[CGW_IMAGE_GOVERNOR_OWN_NODE];
    result.gateway_node = record[CGW_IMAGE_GOVERNOR_GATEWAY_NODE];
    result.manual_timing = record[CGW_IMAGE_GOVERNOR_MANUAL_TIMING];
    result.send_errors = record[CGW_IMAGE_GOVERNOR_SEND_ERRORS];
    result.send_status = record[CGW_IMAGE_GOVERNOR_SEND_STATUS];
    result.bit_rate_kbit = cgw_image_u16(record + CGW_IMAGE_GOVERNOR_BIT_RATE_KBIT);
    cgw_image_copy(result.registers, record + CGW_IMAGE_GOVERNOR_REGISTERS, sizeof result.registers);
    result.start_up_delay_ms = cgw_image_u32(record + CGW_IMAGE_GOVERNOR_START_UP_DELAY_MS);
    result.main_cycle_us = cgw_image_u32(record + CGW_IMAGE_GOVERNOR_MAIN_CYCLE_US);
    return result;
}

static inline cgw_image_heartbeat cgw_image_get_heartbeat(const cgw_image* image) {
    const uint8_t* record = cgw_image_record(image, CGW_IMAGE_HEARTBEAT, 0);
    cgw_image_heartbeat result;
    result.producer_us = cgw_image_u32(record + CGW_IMAGE_HEARTBEAT_PRODUCER_US);
    result.consumer_us = cgw_image_u32(record + CGW_IMAGE_HEARTBEAT_CONSUMER_US);
    result.consumer_node = record[CGW_IMAGE_HEARTBEAT_CONSUMER_NODE];
    return result;
}

/* position below CGW_IMAGE_PDO_COUNT: TPDO1..16, RPDO1..4 */
static inline cgw_image_pdo cgw_image_get_pdo(const cgw_image* image, uint32_t position) {
    const uint8_t* record = cgw_image_record(image, CGW_IMAGE_PDOS, position);
    cgw_image_pdo result;
    unsigned word;
    result.receive = record[CGW_IMAGE_PDO_DIRECTION];
    result.number = record[CGW_IMAGE_PDO_NUMBER];
    result.active = record[CGW_IMAGE_PDO_ACTIVE];
    result.cob_id_from_parameter = record[CGW_IMAGE_PDO_COB_ID_SOURCE];
    result.cob_id = cgw_image_u16(record + CGW_IMAGE_PDO_COB_ID);
    result.transmission_type = record[CGW_IMAGE_PDO_TRANSMISSION_TYPE];
    result.word_count = record[CGW_IMAGE_PDO_WORD_COUNT];
    result.effective_us = cgw_image_u32(record + CGW_IMAGE_PDO_EFFECTIVE_US);
    result.asked_ms = cgw_image_u16(record + CGW_IMAGE_PDO_ASKED_MS);
    result.cycles = cgw_image_u16(record + CGW_IMAGE_PDO_CYCLES);
    for (word = 0; word < 4; ++word) {
        const uint32_t mapped = cgw_image_u32(record + CGW_IMAGE_PDO_MAPPING + 4 * word);
        result.words[word].index = (uint16_t)(mapped >> 16);
        result.words[word].sub_index = (uint8_t)(mapped >> 8 & 0xFFu);
        result.words[word].bits = (uint8_t)(mapped & 0xFFu);
        result.words[word].parameter = cgw_image_u16(record + CGW_IMAGE_PDO_PARAMETERS + 2 * word);
    }
    return result;
}

static inline uint32_t cgw_image_object_count(const cgw_image* image) {
    return cgw_image_count(image, CGW_IMAGE_OBJECTS);
}

static inline cgw_image_object cgw_image_get_object(const cgw_image* image, uint32_t position) {
    const uint8_t* record = cgw_image_record(image, CGW_IMAGE_OBJECTS, position);
    cgw_image_object result;
    const uint8_t* value;
    unsigned i;
    result.index = cgw_image_u16(record + CGW_IMAGE_OBJECT_INDEX);
    result.sub_index = record[CGW_IMAGE_OBJECT_SUB_INDEX];
    result.type = record[CGW_IMAGE_OBJECT_TYPE];
    result.access = record[CGW_IMAGE_OBJECT_RIGHTS] & 0x0Fu;
    result.flags = (uint8_t)(record[CGW_IMAGE_OBJECT_RIGHTS] >> 4);
    result.length = cgw_image_type_size(result.type);
    result.offset = cgw_image_u16(record + CGW_IMAGE_OBJECT_OFFSET);
    result.value = 0;
    value = image->sections[CGW_IMAGE_OBJECT_VALUES].data + result.offset;
    for (i = 0; i < result.length; ++i) {
        result.value |= (uint32_t)value[i] << (8 * i);
    }
    return result;
}

static inline int cgw_image_find_object(const cgw_image* image, uint16_t index, uint8_t sub_index,
                                        cgw_image_object* object) {
    uint32_t i;
    for (i = 0; i < cgw_image_object_count(image); ++i) {
        const cgw_image_object one = cgw_image_get_object(image, i);
        if (one.index == index && one.sub_index == sub_index) {
            *object = one;
            return 1;
        }
    }
    return 0;
}

static inline uint32_t cgw_image_switch_count(const cgw_image* image) {
    return cgw_image_count(image, CGW_IMAGE_SWITCHES);
}

static inline cgw_image_switch cgw_image_get_switch(const cgw_image* image, uint32_t position) {
    const uint8_t* record = cgw_image_record(image, CGW_IMAGE_SWITCHES, position);
    cgw_image_switch result;
    result.number = cgw_image_u16(record + CGW_IMAGE_SWITCH_NUMBER);
    result.bit = record[CGW_IMAGE_SWITCH_BIT];
    result.low_active = record[CGW_IMAGE_SWITCH_LOW_ACTIVE];
    return result;
}

static inline uint32_t cgw_image_sensor_count(const cgw_image* image) {
    return cgw_image_count(image, CGW_IMAGE_SENSORS);
}

static inline cgw_image_sensor cgw_image_get_sensor(const cgw_image* image, uint32_t position) {
    const uint8_t* record = cgw_image_record(image, CGW_IMAGE_SENSORS, position);
    cgw_image_sensor result;
    result.number = cgw_image_u16(record + CGW_IMAGE_SENSOR_NUMBER);
    result.channel = record[CGW_IMAGE_SENSOR_CHANNEL];
    return result;
}

static inline uint32_t cgw_image_signal_count(const cgw_image* image) {
    return cgw_image_count(image, CGW_IMAGE_SIGNALS);
}

/* A word of the wire as a number: two's complement when it is signed. */
static inline int32_t cgw_image_limit(uint16_t word, int is_signed) {
    return is_signed && word >= 0x8000u ? (int32_t)word - 0x10000 : (int32_t)word;
}

static inline cgw_image_signal cgw_image_get_signal(const cgw_image* image, uint32_t position) {
    const uint8_t* record = cgw_image_record(image, CGW_IMAGE_SIGNALS, position);
    cgw_image_signal result;
    result.number = cgw_image_u16(record + CGW_IMAGE_SIGNAL_NUMBER);
    result.width = record[CGW_IMAGE_SIGNAL_WIDTH];
    result.is_signed = record[CGW_IMAGE_SIGNAL_IS_SIGNED];
    result.internal_minimum =
        cgw_image_limit(cgw_image_u16(record + CGW_IMAGE_SIGNAL_INTERNAL_MINIMUM), result.is_signed);
    result.internal_maximum =
        cgw_image_limit(cgw_image_u16(record + CGW_IMAGE_SIGNAL_INTERNAL_MAXIMUM), result.is_signed);
    return result;
}

static inline int cgw_image_find_signal(const cgw_image* image, uint16_t number, cgw_image_signal* signal) {
    uint32_t i;
    for (i = 0; i < cgw_image_signal_count(image); ++i) {
        const cgw_image_signal one = cgw_image_get_signal(image, i);
        if (one.number == number) {
            *signal = one;
            return 1;
        }
    }
    return 0;
}

/* 0 for an image without labels. */
static inline uint32_t cgw_image_label_count(const cgw_image* image) {
    return cgw_image_count(image, CGW_IMAGE_LABELS);
}

static inline cgw_image_label cgw_image_get_label(const cgw_image* image, uint32_t position) {
    const uint8_t* record = cgw_image_record(image, CGW_IMAGE_LABELS, position);
    const char* strings = (const char*)image->sections[CGW_IMAGE_STRINGS].data;
    cgw_image_label result;
    result.number = cgw_image_u16(record + CGW_IMAGE_LABEL_NUMBER);
    result.name = strings + cgw_image_u32(record + CGW_IMAGE_LABEL_NAME_OFFSET);
    result.unit = strings + cgw_image_u32(record + CGW_IMAGE_LABEL_UNIT_OFFSET);
    result.name_length = record[CGW_IMAGE_LABEL_NAME_LENGTH];
    result.unit_length = record[CGW_IMAGE_LABEL_UNIT_LENGTH];
    result.has_scaling = record[CGW_IMAGE_LABEL_HAS_SCALING];
    result.external_minimum = cgw_image_f64(record + CGW_IMAGE_LABEL_EXTERNAL_MINIMUM);
    result.external_maximum = cgw_image_f64(record + CGW_IMAGE_LABEL_EXTERNAL_MAXIMUM);
    return result;
}

static inline int cgw_image_find_label(const cgw_image* image, uint16_t number, cgw_image_label* label) {
    uint32_t i;
    for (i = 0; i < cgw_image_label_count(image); ++i) {
        const cgw_image_label one = cgw_image_get_label(image, i);
        if (one.number == number) {
            *label = one;
            return 1;
        }
    }
    return 0;
}

/* The canonical model, the text whose SHA-256 is the configuration id: UTF-8, not terminated. NULL and 0 for
   an image without it. */
static inline const char* cgw_image_model(const cgw_image* image, uint32_t* length) {
    *length = image->sections[CGW_IMAGE_MODEL].size;
    return (const char*)image->sections[CGW_IMAGE_MODEL].data;
}

#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif
