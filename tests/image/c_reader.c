#include "c_reader.h"

struct sink {
    c_reader_put put;
    void* to;
};

static void number(const struct sink* sink, uint64_t value) {
    sink->put(sink->to, value);
}

static void bytes_of(const struct sink* sink, const void* from, size_t count) {
    const unsigned char* byte = (const unsigned char*)from;
    while (count-- != 0) {
        number(sink, *byte++);
    }
}

static void put_devices(const struct sink* sink, const cgw_image* image) {
    const cgw_image_identity identity = cgw_image_get_identity(image);
    const cgw_image_governor governor = cgw_image_get_governor(image);
    const cgw_image_heartbeat heartbeat = cgw_image_get_heartbeat(image);
    unsigned i;
    number(sink, cgw_image_format_major(image));
    number(sink, cgw_image_format_minor(image));
    for (i = 0; i < 3; ++i) {
        number(sink, cgw_image_tool_version(image, i));
    }
    bytes_of(sink, cgw_image_configuration_id(image), CGW_IMAGE_HEADER_CONFIGURATION_ID_SIZE);
    number(sink, cgw_image_crc(image));
    number(sink, identity.vendor);
    number(sink, identity.product);
    number(sink, identity.revision);
    number(sink, identity.serial);
    for (i = 0; i < CGW_IMAGE_BUS_COUNT; ++i) {
        const cgw_image_bus bus = cgw_image_get_bus(image, i);
        number(sink, bus.own_node);
        number(sink, bus.peer_node);
        number(sink, bus.manual_timing);
        number(sink, bus.bit_rate_kbit);
        bytes_of(sink, bus.registers, sizeof bus.registers);
        number(sink, bus.start_up_delay_ms);
    }
    number(sink, governor.own_node);
    number(sink, governor.gateway_node);
    number(sink, governor.manual_timing);
    number(sink, governor.send_errors);
    number(sink, governor.send_status);
    number(sink, governor.bit_rate_kbit);
    bytes_of(sink, governor.registers, sizeof governor.registers);
    number(sink, governor.start_up_delay_ms);
    number(sink, governor.main_cycle_us);
    number(sink, heartbeat.producer_us);
    number(sink, heartbeat.consumer_us);
    number(sink, heartbeat.consumer_node);
}

static void put_pdos(const struct sink* sink, const cgw_image* image) {
    uint32_t i;
    unsigned word;
    for (i = 0; i < CGW_IMAGE_PDO_COUNT; ++i) {
        const cgw_image_pdo pdo = cgw_image_get_pdo(image, i);
        number(sink, pdo.receive);
        number(sink, pdo.number);
        number(sink, pdo.active);
        number(sink, pdo.cob_id_from_parameter);
        number(sink, pdo.cob_id);
        number(sink, pdo.transmission_type);
        number(sink, pdo.effective_us);
        number(sink, pdo.asked_ms);
        number(sink, pdo.cycles);
        number(sink, pdo.word_count);
        for (word = 0; word < 4; ++word) {
            number(sink, pdo.words[word].index);
            number(sink, pdo.words[word].sub_index);
            number(sink, pdo.words[word].bits);
            number(sink, pdo.words[word].parameter);
        }
    }
}

static void put_objects(const struct sink* sink, const cgw_image* image) {
    uint32_t i;
    number(sink, cgw_image_object_count(image));
    for (i = 0; i < cgw_image_object_count(image); ++i) {
        const cgw_image_object object = cgw_image_get_object(image, i);
        number(sink, object.index);
        number(sink, object.sub_index);
        number(sink, object.type);
        number(sink, object.access);
        number(sink, object.flags);
        number(sink, object.length);
        number(sink, object.offset);
        number(sink, object.value);
    }
}

static void put_inputs_and_signals(const struct sink* sink, const cgw_image* image) {
    uint32_t i;
    number(sink, cgw_image_switch_count(image));
    for (i = 0; i < cgw_image_switch_count(image); ++i) {
        const cgw_image_switch function = cgw_image_get_switch(image, i);
        number(sink, function.number);
        number(sink, function.bit);
        number(sink, function.low_active);
    }
    number(sink, cgw_image_sensor_count(image));
    for (i = 0; i < cgw_image_sensor_count(image); ++i) {
        const cgw_image_sensor sensor = cgw_image_get_sensor(image, i);
        number(sink, sensor.number);
        number(sink, sensor.channel);
    }
    number(sink, cgw_image_signal_count(image));
    for (i = 0; i < cgw_image_signal_count(image); ++i) {
        const cgw_image_signal signal = cgw_image_get_signal(image, i);
        number(sink, signal.number);
        number(sink, signal.width);
        number(sink, signal.is_signed);
        number(sink, (uint64_t)(int64_t)signal.internal_minimum);
        number(sink, (uint64_t)(int64_t)signal.internal_maximum);
    }
}

static void put_labels(const struct sink* sink, const cgw_image* image) {
    uint32_t i;
    number(sink, cgw_image_label_count(image));
    for (i = 0; i < cgw_image_label_count(image); ++i) {
        const cgw_image_label label = cgw_image_get_label(image, i);
        number(sink, label.number);
        number(sink, label.name_length);
        bytes_of(sink, label.name, label.name_length);
        number(sink, label.unit_length);
        bytes_of(sink, label.unit, label.unit_length);
        number(sink, label.has_scaling);
        bytes_of(sink, &label.external_minimum, sizeof label.external_minimum);
        bytes_of(sink, &label.external_maximum, sizeof label.external_maximum);
    }
}

static void put_model(const struct sink* sink, const cgw_image* image) {
    uint32_t length;
    const char* model = cgw_image_model(image, &length);
    number(sink, length);
    bytes_of(sink, model, length);
}

size_t c_reader_in(const void* area, size_t size) {
    return cgw_image_in(area, size);
}

unsigned c_reader_open_region(const void* region, size_t region_size) {
    cgw_image image;
    const size_t size = cgw_image_in(region, region_size);
    return cgw_image_open(&image, region, size);
}

unsigned c_reader_dump(const void* bytes, size_t size, c_reader_put put, void* to) {
    const struct sink sink = {put, to};
    cgw_image image;
    const unsigned status = cgw_image_open(&image, bytes, size);
    if (status == CGW_IMAGE_OK) {
        put_devices(&sink, &image);
        put_pdos(&sink, &image);
        put_objects(&sink, &image);
        put_inputs_and_signals(&sink, &image);
        put_labels(&sink, &image);
        put_model(&sink, &image);
    }
    return status;
}

static int finds_objects(const cgw_image* image) {
    cgw_image_object found;
    uint32_t i;
    for (i = 0; i < cgw_image_object_count(image); ++i) {
        const cgw_image_object object = cgw_image_get_object(image, i);
        if (!cgw_image_find_object(image, object.index, object.sub_index, &found) ||
            found.offset != object.offset) {
            return 0;
        }
    }
    found.index = 0xFFFF;
    return !cgw_image_find_object(image, 0x1005, 0, &found) &&
           !cgw_image_find_object(image, 0x1018, 5, &found) && found.index == 0xFFFF;
}

static int finds_signals_and_labels(const cgw_image* image) {
    cgw_image_signal signal;
    cgw_image_label label;
    uint32_t i;
    for (i = 0; i < cgw_image_signal_count(image); ++i) {
        const uint16_t wanted = cgw_image_get_signal(image, i).number;
        if (!cgw_image_find_signal(image, wanted, &signal) || signal.number != wanted) {
            return 0;
        }
    }
    for (i = 0; i < cgw_image_label_count(image); ++i) {
        const uint16_t wanted = cgw_image_get_label(image, i).number;
        if (!cgw_image_find_label(image, wanted, &label) || label.number != wanted) {
            return 0;
        }
    }
    signal.number = label.number = 0xFFFF;
    return !cgw_image_find_signal(image, 0, &signal) && signal.number == 0xFFFF &&
           !cgw_image_find_label(image, 1, &label) && label.number == 0xFFFF;
}

int c_reader_finds(const void* bytes, size_t size) {
    cgw_image image;
    return cgw_image_open(&image, bytes, size) == CGW_IMAGE_OK && finds_objects(&image) &&
           finds_signals_and_labels(&image);
}
