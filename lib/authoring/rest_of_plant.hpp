// Inside the authoring room: a data sheet and the parameter file of the same plant made into one. The data
// sheet counts where both say something; where they contradict each other, that is told.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "authoring/from_data_sheet.hpp"
#include "authoring/image_draft.hpp"

namespace cgw::authoring {

class RestOfPlant {
  public:
    // Without a plant (nullptr) the data sheet alone counts. What the plant declares, and what it says beside
    // parameters, goes into the draft at once.
    RestOfPlant(ImageDraft& to, const PlantSource* plant);

    const PlantSource* plant() const { return plant_; }
    std::uint32_t main_cycle_us() const;

    // The data sheet says this value; 0 is off.
    void say(parameter::Device device, std::uint16_t number, double value);

    // It says what a time becomes in whole main cycles. The plant's time stays where it becomes the same;
    // `asked_ms` counts elsewhere.
    void say_time(parameter::Device device, std::uint16_t number, std::uint32_t effective_ms, double asked_ms,
                  const config::CyclicTime* of_plant);

    // kbit/s of CAN2. Timing that the plant sets by hand stays where it makes the same rate.
    void say_bit_rate(std::uint32_t kbit);

    // Whether the plant's TPDO sends these words: measurements, nullptr for one that is not known.
    bool sends(int tpdo, const std::vector<const parameter::Row*>& words) const;

    // What the device takes from that channel, or as switches: all but `stays`, which may be nullptr, is
    // nothing there by the data sheet. False where the plant has `stays` there, with whatever shares it.
    bool clear_channel(std::uint8_t channel, const parameter::Row* stays);
    void clear_switches();

    // Takes all that was not said from the plant. What of it cannot be written, a phrase each, is in the
    // draft's `lost`.
    void finish();

    // "427 CanOpMyNodeNumber: 12, not 13", by device and number.
    std::vector<std::string> contradictions() const;

  private:
    using Key = std::pair<parameter::Device, std::uint16_t>;

    void take_sections();
    void contradict(parameter::Device device, std::uint16_t number, double value);
    void clear(std::uint16_t assignment);

    ImageDraft& to_;
    const PlantSource* plant_;
    std::set<Key> said_;
    std::map<Key, std::string> contradictions_;
};

}  // namespace cgw::authoring
