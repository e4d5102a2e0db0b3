# Compiles a parameter file into a target, at build time.
#
#   include(CgwEmbedConfig)
#   cgw_embed_config(
#     TARGET firmware            # an executable or library of this directory
#     CONFIG plant.toml          # relative to the current source directory
#     [SECTION .cgw_config]      # linker section of the image
#     [ALIGNMENT 8]              # bytes, a power of two
#     [SYMBOL cgw_config_image]  # C identifier of the image; its size is <SYMBOL>_size
#     [NO_LABELS])               # leave out names and units, which only displays need
#
# The program sees `extern "C" const unsigned char cgw_config_image[];` and `extern "C" const unsigned int
# cgw_config_image_size;` and gives what cgw::image::image_in finds there to cgw::image::Image::open. A linker that
# drops unused sections needs KEEP(*(.cgw_config)) when nothing refers to the symbol.
#
# The file is compiled by a cgw that runs on the building machine: CGW_EXECUTABLE where it is set, else the target
# `cgw` (not in a cross build) or `cgw::cgw`. An invalid file fails the build with cgw's
# `file:line:column: error: …`. A change of the file, of a catalogue it names, or of cgw compiles it again.
if(CMAKE_VERSION VERSION_LESS 3.21)
  message(FATAL_ERROR "CgwEmbedConfig needs CMake 3.21 or newer")
endif()

cmake_policy(PUSH)
cmake_policy(VERSION 3.21)  # CMP0116: depfiles may name absolute paths, whatever the generator

# Sets `command` and `dependency` in the caller: how to run the host's cgw, and what stands for its version.
function(_cgw_find_host_program)
  if(CGW_EXECUTABLE)
    # A name without a directory is looked up in PATH.
    find_program(_cgw_program NAMES "${CGW_EXECUTABLE}" NO_CACHE NO_CMAKE_FIND_ROOT_PATH)
    if(NOT _cgw_program)
      message(FATAL_ERROR "cgw_embed_config: CGW_EXECUTABLE is '${CGW_EXECUTABLE}', which is no program")
    endif()
    set(command "${_cgw_program}" PARENT_SCOPE)
    set(dependency "${_cgw_program}" PARENT_SCOPE)
    return()
  endif()
  set(candidates cgw cgw::cgw)
  if(CMAKE_CROSSCOMPILING)
    set(candidates cgw::cgw)  # this build's own cgw would not run here
  endif()
  foreach(candidate IN LISTS candidates)
    if(TARGET ${candidate})
      set(command "$<TARGET_FILE:${candidate}>" PARENT_SCOPE)
      set(dependency ${candidate} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  list(JOIN candidates " or " candidates)
  message(FATAL_ERROR "cgw_embed_config: neither CGW_EXECUTABLE is set nor a target ${candidates} exists")
endfunction()

function(cgw_embed_config)
  cmake_parse_arguments(PARSE_ARGV 0 embed "NO_LABELS" "TARGET;CONFIG;SECTION;ALIGNMENT;SYMBOL" "")
  if(embed_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "cgw_embed_config: unknown arguments: ${embed_UNPARSED_ARGUMENTS}")
  endif()
  foreach(required IN ITEMS TARGET CONFIG)
    if(NOT embed_${required})
      message(FATAL_ERROR "cgw_embed_config: ${required} is missing")
    endif()
  endforeach()
  foreach(default IN ITEMS "SECTION=.cgw_config" "ALIGNMENT=8" "SYMBOL=cgw_config_image")
    string(REGEX MATCH "^([A-Z]+)=(.*)$" _ "${default}")
    if(NOT DEFINED embed_${CMAKE_MATCH_1})
      set(embed_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
    endif()
  endforeach()

  if(NOT TARGET ${embed_TARGET})
    message(FATAL_ERROR "cgw_embed_config: there is no target ${embed_TARGET}")
  endif()
  get_target_property(target_directory ${embed_TARGET} SOURCE_DIR)
  if(NOT target_directory STREQUAL CMAKE_CURRENT_SOURCE_DIR)
    message(FATAL_ERROR "cgw_embed_config: call it in the directory that creates ${embed_TARGET}")
  endif()
  if(NOT embed_SYMBOL MATCHES "^[A-Za-z_][A-Za-z0-9_]*$")
    message(FATAL_ERROR "cgw_embed_config: SYMBOL '${embed_SYMBOL}' is not a C identifier")
  endif()
  if(NOT embed_ALIGNMENT MATCHES "^(1|2|4|8|16|32|64|128|256|512|1024|2048|4096)$")
    message(FATAL_ERROR "cgw_embed_config: ALIGNMENT '${embed_ALIGNMENT}' is not a power of two up to 4096")
  endif()

  set(labels "")
  if(embed_NO_LABELS)
    set(labels --no-labels)
  endif()
  _cgw_find_host_program()
  get_filename_component(config "${embed_CONFIG}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  set(output "${CMAKE_CURRENT_BINARY_DIR}/cgw_embed/${embed_TARGET}_${embed_SYMBOL}.cpp")
  file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/cgw_embed")
  # cgw leaves an identical file untouched; the time stamp then tells every generator that it is up to date.
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${command}" emit image-source "${config}" -o "${output}"
            --section "${embed_SECTION}" --align "${embed_ALIGNMENT}" --symbol "${embed_SYMBOL}" ${labels}
            --depfile "${output}.d"
    COMMAND "${CMAKE_COMMAND}" -E touch_nocreate "${output}"
    DEPENDS "${config}" ${dependency}
    DEPFILE "${output}.d"
    COMMENT "Compiling configuration ${embed_CONFIG}"
    VERBATIM)
  target_sources(${embed_TARGET} PRIVATE "${output}")
endfunction()

cmake_policy(POP)
