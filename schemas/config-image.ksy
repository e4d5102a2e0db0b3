# The configuration image of cgw as a Kaitai Struct specification. Made from lib/inspect/fields.cpp; changes
# here are lost (CGW_UPDATE_GOLDEN=1 ./test -R inspect makes it again). docs/image-format.md tells the same in
# prose. It takes sound images apart and verifies none: CRC-32, order and ranges are for a reader to check.
meta:
  id: config_image
  title: Configuration image of a CANopen gateway
  file-extension: bin
  endian: le
doc: "Format 1.0."
seq:
  - id: header
    type: record_header
  - id: more_header
    size: header.header_size - 64
    doc: "of a later minor"
  - id: directory
    type: record_directory
    repeat: expr
    repeat-expr: header.section_count
instances:
  trailer:
    pos: header.total_size - 4
    type: record_trailer
types:
  record_header:
    seq:
      - id: magic
        contents: CGWI
        doc: "the letters `CGWI`"
      - id: format_major
        type: u2
        doc: "another one is refused; 1"
      - id: format_minor
        type: u2
        doc: "a higher one only adds"
      - id: header_size
        type: u2
        doc: "where the directory begins; 64 in minor 0, a multiple of 4"
      - id: section_count
        type: u2
        doc: "entries of the directory"
      - id: total_size
        type: u4
        doc: "bytes of the whole image; CRC-32 included"
      - id: configuration_id
        size: 32
        doc: "SHA-256 of the canonical model"
      - id: tool_version
        type: u2
        repeat: expr
        repeat-expr: 3
        doc: "the cgw that wrote the image"
      - id: reserved
        size: 10
        doc: "0"
  record_directory:
    seq:
      - id: id
        type: u2
        doc: "the section's number; from the table below; ascending"
      - id: record_size
        type: u2
        doc: "bytes of one record; from one to the next"
      - id: offset
        type: u4
        doc: "where the section begins; from the image's first byte"
      - id: size
        type: u4
        doc: "bytes of the section; a multiple of record_size"
    instances:
      content:
        io: _root._io
        pos: offset
        size: size
        type:
          switch-on: id
          cases:
            1: section_identity(record_size)
            2: section_buses(record_size)
            3: section_governor(record_size)
            4: section_heartbeat(record_size)
            5: section_pdos(record_size)
            6: section_objects(record_size)
            8: section_switches(record_size)
            9: section_sensors(record_size)
            10: section_signals(record_size)
            11: section_labels(record_size)
            12: text
            13: text
  record_identity:
    doc: "object 1018h"
    seq:
      - id: vendor
        type: u4
        doc: "1018h:1"
      - id: product
        type: u4
        doc: "1018h:2"
      - id: revision
        type: u4
        doc: "1018h:3 (D32)"
      - id: serial
        type: u4
        doc: "1018h:4 (D32)"
  section_identity:
    params:
      - id: record_size
        type: u2
    seq:
      - id: records
        size: record_size
        type: record_identity
        repeat: eos
  record_buses:
    doc: "CAN1 (HEINZMANN), CAN2 (CANopen)"
    seq:
      - id: own_node
        type: u1
        doc: "the gateway's node; 1..127; on CAN1 at most 31 (401 / 427)"
      - id: peer_node
        type: u1
        doc: "the other end's node; 0..127; on CAN1 the governor, on CAN2 the partner, 0 for none (402 / 428)"
      - id: manual_timing
        type: u1
        doc: "1: registers hold; 0: the bit rate (4416 / 4426)"
      - id: reserved
        type: u1
        doc: "0"
      - id: bit_rate_kbit
        type: u2
        doc: "kbit/s; 0, 125, 250, 500 or 1000; 0 only with manual timing (416 / 426)"
      - id: registers
        type: u1
        repeat: expr
        repeat-expr: 6
        doc: "bit-timing registers; prescaler 0..63, jump width 0..3, sampling 0..1, phase 1, phase 2 and propagation 0..7, as typed (410..415 / 420..425)"
      - id: start_up_delay_ms
        type: u4
        doc: "ms until it talks; 0..100000; 0 on CAN2 (400)"
  section_buses:
    params:
      - id: record_size
        type: u2
    seq:
      - id: records
        size: record_size
        type: record_buses
        repeat: eos
  record_governor:
    doc: "the governor's half of the configuration"
    seq:
      - id: own_node
        type: u1
        doc: "the governor's node; 1..31 (401)"
      - id: gateway_node
        type: u1
        doc: "the gateway's node; 1..31 (403)"
      - id: manual_timing
        type: u1
        doc: "1: registers hold (4416)"
      - id: send_errors
        type: u1
        doc: "1: TPDO1, 2 sent (14401)"
      - id: bit_rate_kbit
        type: u2
        doc: "kbit/s; 0, 125, 250, 500 or 1000; 0 only with manual timing (416)"
      - id: registers
        type: u1
        repeat: expr
        repeat-expr: 5
        doc: "bit-timing registers; as in `buses`; the governor has no propagation segment (410..414)"
      - id: reserved
        type: u1
        doc: "0"
      - id: start_up_delay_ms
        type: u4
        doc: "ms until it talks; 0..100000 (400)"
      - id: main_cycle_us
        type: u4
        doc: "main cycle of the governor; at least 1; µs"
      - id: send_status
        type: u1
        doc: "1: TPDO3 sent (14402)"
      - id: reserved_2
        type: u1
        repeat: expr
        repeat-expr: 3
        doc: "0"
  section_governor:
    params:
      - id: record_size
        type: u2
    seq:
      - id: records
        size: record_size
        type: record_governor
        repeat: eos
  record_heartbeat:
    doc: "own and monitored heartbeat"
    seq:
      - id: producer_us
        type: u4
        doc: "own heartbeat, 0: off; effective period (D8), whole gateway cycles of 16000 µs, at most 4095 (429)"
      - id: consumer_us
        type: u4
        doc: "monitoring time, 0: off; effective, likewise (430)"
      - id: consumer_node
        type: u1
        doc: "the partner, 0: none; 0..127 (428)"
      - id: reserved
        type: u1
        repeat: expr
        repeat-expr: 3
        doc: "0"
  section_heartbeat:
    params:
      - id: record_size
        type: u2
    seq:
      - id: records
        size: record_size
        type: record_heartbeat
        repeat: eos
  record_pdos:
    doc: "TPDO1..16, RPDO1..4"
    seq:
      - id: direction
        type: u1
        enum: pdos_direction
        doc: "0 transmit, 1 receive"
      - id: number
        type: u1
        doc: "1..16 or 1..4, in order; 1..16"
      - id: active
        type: u1
        doc: "1: sent or received"
      - id: cob_id_source
        type: u1
        enum: pdos_cob_id_source
        doc: "0 follows the node number, 1 parameter; TPDO1..4 and RPDO1..4 follow the node number"
      - id: cob_id
        type: u2
        doc: "identifier; 0..2047; kept when inactive; over active PDOs unique and not reserved (D33) (TPDO5..16: 16404..16415)"
      - id: word_count
        type: u1
        doc: "words that it carries; 0..4; 1..4 when active, else 0"
      - id: transmission_type
        type: u1
        doc: "on change or cyclic (D31); 254"
      - id: effective_us
        type: u4
        doc: "cycle or monitoring time; cycles × main_cycle_us (D8); 0 for TPDO1..3"
      - id: asked_ms
        type: u2
        doc: "ms, as typed (16460..16472, 16480..16483)"
      - id: cycles
        type: u2
        doc: "governor main cycles; 0..255"
      - id: mapping
        type: u4
        repeat: expr
        repeat-expr: 4
        doc: "the object in the word; index × 65536 + sub-index × 256 + 16 bits; unused words 0"
      - id: parameters
        type: u2
        repeat: expr
        repeat-expr: 4
        doc: "what the word carries; number of the measurement or sensor, 0 for none (16400..16451)"
  section_pdos:
    params:
      - id: record_size
        type: u2
    seq:
      - id: records
        size: record_size
        type: record_pdos
        repeat: eos
  record_objects:
    doc: "the object dictionary"
    seq:
      - id: index
        type: u2
        doc: "object; 1000h..FFFFh; records ascend by index, then sub-index, each pair once"
      - id: sub_index
        type: u1
        doc: "0..254"
      - id: type
        type: u1
        enum: objects_type
        doc: "CiA 301 data type; 1 BOOLEAN, 2 INTEGER8, 3 INTEGER16, 4 INTEGER32, 5 UNSIGNED8, 6 UNSIGNED16, 7 UNSIGNED32"
      - id: rights
        type: u1
        doc: "access and flags; 0 ro, 1 wo, 2 rw, 3 rwr, 4 rww, 5 const; 16 mappable into a PDO, 32 never written by SDO (D29); access in bits 0..3, flags in bits 4..7"
      - id: handler
        type: u1
        doc: "plain memory; other numbers are left to later minors"
      - id: offset
        type: u2
        doc: "of the value in its block"
  section_objects:
    params:
      - id: record_size
        type: u2
    seq:
      - id: records
        size: record_size
        type: record_objects
        repeat: eos
  record_switches:
    doc: "switch functions that RPDO1 carries"
    seq:
      - id: number
        type: u2
        doc: "switch function; 811..849; ascending"
      - id: bit
        type: u1
        doc: "bit of 2003h:1; 1..16; RPDO1 word 1; 1 is the least significant (811..849)"
      - id: low_active
        type: u1
        doc: "1: on while the bit is 0"
  section_switches:
    params:
      - id: record_size
        type: u2
    seq:
      - id: records
        size: record_size
        type: record_switches
        repeat: eos
  record_sensors:
    doc: "sensors that RPDO2..4 carry"
    seq:
      - id: number
        type: u2
        doc: "sensor; 900..929; ascending"
      - id: channel
        type: u1
        doc: "word of RPDO2..4; 1..12; object 2004h:channel (900..929)"
      - id: reserved
        type: u1
        doc: "0"
  section_sensors:
    params:
      - id: record_size
        type: u2
    seq:
      - id: records
        size: record_size
        type: record_sensors
        repeat: eos
  record_signals:
    doc: "width, sign and internal range of what the words carry"
    seq:
      - id: number
        type: u2
        doc: "measurement or sensor; 1..29999; ascending, each once"
      - id: width
        type: u1
        doc: "bits before widening; 8 or 16"
      - id: is_signed
        type: u1
        doc: "1: two's complement"
      - id: internal_minimum
        type: u2
        doc: "lowest value on the wire; two's complement when the signal is signed"
      - id: internal_maximum
        type: u2
        doc: "highest value; larger than the lowest; likewise"
  section_signals:
    params:
      - id: record_size
        type: u2
    seq:
      - id: records
        size: record_size
        type: record_signals
        repeat: eos
  record_labels:
    doc: "names, units, engineering ranges; may be left out"
    seq:
      - id: number
        type: u2
        doc: "what is named; 0..29999; 0: the title of the parameter file; else a measurement, sensor or switch; ascending"
      - id: name_length
        type: u1
        doc: "bytes"
      - id: unit_length
        type: u1
        doc: "bytes"
      - id: name_offset
        type: u4
        doc: "of the name, in `strings`"
      - id: unit_offset
        type: u4
        doc: "of the unit, in `strings`"
      - id: has_scaling
        type: u1
        doc: "1: both limits hold"
      - id: reserved
        type: u1
        repeat: expr
        repeat-expr: 3
        doc: "0"
      - id: external_minimum
        type: f8
        doc: "value of internal_minimum; in units; 0 without scaling"
      - id: external_maximum
        type: f8
        doc: "value of internal_maximum; likewise"
  section_labels:
    params:
      - id: record_size
        type: u2
    seq:
      - id: records
        size: record_size
        type: record_labels
        repeat: eos
  record_trailer:
    seq:
      - id: crc32
        type: u4
        doc: "CRC-32 of all bytes before"
  text:
    seq:
      - id: text
        type: str
        encoding: UTF-8
        size-eos: true
enums:
  section_id:
    1: identity
    2: buses
    3: governor
    4: heartbeat
    5: pdos
    6: objects
    7: object_values
    8: switches
    9: sensors
    10: signals
    11: labels
    12: strings
    13: model
  pdos_direction:
    0: transmit
    1: receive
  pdos_cob_id_source:
    0: node_number
    1: parameter
  objects_type:
    1: boolean
    2: integer8
    3: integer16
    4: integer32
    5: unsigned8
    6: unsigned16
    7: unsigned32
