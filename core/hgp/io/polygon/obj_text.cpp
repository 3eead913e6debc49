#include "hgp/io/polygon/obj_text.h"

#include "hgp/text/text.h"

namespace hgp::io {
namespace {

bool takeIndexText(const char*& p, const char* end, std::string_view& out) {
  const char* begin = p;
  if (p != end && (*p == '-' || *p == '+')) ++p;
  const char* digits = p;
  while (p != end && text::isDigit(*p)) ++p;
  out = std::string_view(begin, static_cast<std::size_t>(p - begin));
  return p != digits;
}

}  // namespace

bool takeObjCorner(const char*& p, const char* end, ObjCorner& corner) {
  corner = {};
  if (!takeIndexText(p, end, corner.vertex)) return false;
  if (p == end || *p != '/') return true;
  ++p;
  if (p != end && *p != '/') takeIndexText(p, end, corner.uv);
  if (p == end || *p != '/') return true;
  ++p;
  takeIndexText(p, end, corner.normal);
  return true;
}

}  // namespace hgp::io
