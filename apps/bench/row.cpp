#include "apps/bench/row.h"

namespace ringlet {

Json as_json(const BenchRow& row) {
  Json json{{"name", row.name}};
  const auto put = [&json](const char* key, const auto& value) {
    if (value) json[key] = *value;
  };
  const auto put_object = [&json](const char* key, const Json& object) {
    if (!object.empty()) json[key] = object;
  };
  put_object("parameters", row.parameters);
  if (row.time) json.update({{"seconds", row.time->median}, {"spread", row.time->spread}});
  put_object("stages", row.stages);
  put("ratio", row.ratio);
  put("iterations", row.iterations);
  put("contacts", row.contacts);
  put("bytes", row.bytes);
  put_object("figures", row.figures);
  return json;
}

}  // namespace ringlet
