// Changes one chunk of a GLB and keeps its lengths true, so that mutants get past the container.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace hgp::fuzz {

inline std::uint32_t wordAt(const std::uint8_t* p) {
  std::uint32_t value;
  std::memcpy(&value, p, 4);
  return value;
}

inline std::size_t mutateGlb(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                             unsigned seed) {
  const bool isGlb = size >= 20 && wordAt(data) == 0x46546C67 && wordAt(data + 12) <= size - 20;
  if (!isGlb || seed % 16 == 0) return LLVMFuzzerMutate(data, size, maxSize);
  const std::size_t jsonSize = wordAt(data + 12);
  std::vector<std::uint8_t> json(data + 20, data + 20 + jsonSize),
      rest(data + 20 + jsonSize, data + size);
  const bool isBin = rest.size() > 8 && seed % 4 == 1;
  std::vector<std::uint8_t>& part = isBin ? rest : json;
  const std::size_t head = isBin ? 8 : 0, old = part.size();
  const std::size_t room = maxSize > size + 4 ? maxSize - size - 4 : 0;
  part.resize(old + std::min<std::size_t>(room, 4096));
  const std::size_t changed = LLVMFuzzerMutate(part.data() + head, old - head, part.size() - head);
  part.resize(head + changed);
  while (part.size() % 4 != 0) part.push_back(isBin ? 0 : ' ');
  if (isBin) {
    const auto length = static_cast<std::uint32_t>(part.size() - 8);
    std::memcpy(part.data(), &length, 4);
  }
  const std::size_t total = 20 + json.size() + rest.size();
  if (total > maxSize) return size;
  const auto jsonLength = static_cast<std::uint32_t>(json.size()),
             whole = static_cast<std::uint32_t>(total);
  std::copy(json.begin(), json.end(), data + 20);
  std::copy(rest.begin(), rest.end(), data + 20 + json.size());
  std::memcpy(data + 8, &whole, 4);
  std::memcpy(data + 12, &jsonLength, 4);
  return total;
}

}  // namespace hgp::fuzz
