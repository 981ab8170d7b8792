#include "io/exr_layers.hpp"

#include <algorithm>
#include <string_view>

#include "io/uri.hpp"

namespace facet::io {

namespace {

bool hasChannel(const ExrPartChannels& part, const std::string& channel) {
  return std::ranges::find(part.channels, channel) != part.channels.end();
}

std::string layerName(const ExrPartChannels& part, std::string_view prefix) {
  if (prefix.ends_with('.')) prefix.remove_suffix(1);
  if (part.name.empty() || prefix.empty()) return part.name + std::string(prefix);
  return part.name + "." + std::string(prefix);
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return lower;
}

std::string_view lastComponent(std::string_view name) { return name.substr(name.rfind('.') + 1); }

// What renderers call the picture itself.
bool isPictureItself(const ExrLayer& layer) {
  constexpr std::string_view names[] = {"combined", "beauty", "rgba", "rgb", "c", "color", "colour", "image"};
  return std::ranges::find(names, lowerCase(lastComponent(layer.name))) != std::end(names);
}

std::string listedNames(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.size() > 200 ? text.substr(0, 200) + " ..." : text;
}

}  // namespace

std::vector<ExrLayer> exrLayers(const std::vector<ExrPartChannels>& parts) {
  std::vector<ExrLayer> layers;
  for (size_t p = 0; p < parts.size(); ++p) {
    std::vector<std::string> prefixes;
    for (const std::string& channel : parts[p].channels) {
      std::string prefix = channel.substr(0, channel.rfind('.') + 1);
      if (std::ranges::find(prefixes, prefix) == prefixes.end()) prefixes.push_back(std::move(prefix));
    }
    for (const std::string& prefix : prefixes) {
      ExrLayer layer{p, prefix, layerName(parts[p], prefix), ExrColor::rgb, hasChannel(parts[p], prefix + "A")};
      if (hasChannel(parts[p], prefix + "R") && hasChannel(parts[p], prefix + "G") &&
          hasChannel(parts[p], prefix + "B")) {
        layers.push_back(std::move(layer));
      } else if (hasChannel(parts[p], prefix + "Y")) {
        const bool reds = hasChannel(parts[p], prefix + "RY"), blues = hasChannel(parts[p], prefix + "BY");
        if (reds != blues) continue;
        layer.color = reds ? ExrColor::luminanceChroma : ExrColor::grey;
        layers.push_back(std::move(layer));
      }
    }
  }
  return layers;
}

Result<ExrLayer> chooseExrLayer(const std::vector<ExrPartChannels>& parts, const std::string& wanted) {
  const std::vector<ExrLayer> layers = exrLayers(parts);
  if (layers.empty()) {
    std::vector<std::string> channels;
    for (const ExrPartChannels& part : parts)
      for (const std::string& channel : part.channels)
        channels.push_back(part.name.empty() ? channel : part.name + "." + channel);
    return fail("", "", "there are no channels R, G, B or Y, but " + listedNames(channels), "convert it to RGB");
  }
  const auto first = [&](const auto& matches) { return std::ranges::find_if(layers, matches); };
  if (!wanted.empty()) {
    auto found = first([&](const ExrLayer& layer) { return layer.name == wanted; });
    if (found == layers.end())
      found = first([&](const ExrLayer& layer) { return lastComponent(layer.name) == wanted; });
    if (found != layers.end()) return *found;
    std::vector<std::string> names;
    for (const ExrLayer& layer : layers) names.push_back(layer.name.empty() ? "one without a name" : layer.name);
    return fail("", "", "there is no layer " + inQuotes(wanted) + ", but " + listedNames(names), "name one of them");
  }
  auto chosen = parts.size() == 1 ? first([](const ExrLayer& layer) { return layer.prefix.empty(); }) : layers.end();
  if (chosen == layers.end()) chosen = first(isPictureItself);
  if (chosen == layers.end())
    chosen = first([](const ExrLayer& layer) { return layer.part == 0 && layer.prefix.empty(); });
  return chosen == layers.end() ? layers.front() : *chosen;
}

}  // namespace facet::io
