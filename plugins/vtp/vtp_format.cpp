#include "plugins/vtp/vtp_format.h"

#include <spdlog/fmt/fmt.h>

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace ringlet {
namespace {

/// Writes the elements <DataArray> of a file, and at its end the data that was appended.
class ArrayWriter {
 public:
  ArrayWriter(VtpEncoding encoding, std::ostream& stream) : encoding_(encoding), stream_(stream) {}

  template <class T>
  void write(const char* name, int components, const std::vector<T>& values) {
    stream_ << fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" ",
                           type_name(T{}), name, components);
    if (encoding_ == VtpEncoding::ascii) {
      stream_ << fmt::format("format=\"ascii\">\n{}\n</DataArray>\n", fmt::join(values, " "));
    } else {
      stream_ << fmt::format("format=\"appended\" offset=\"{}\"/>\n", appended_.size());
      const std::uint64_t bytes = values.size() * sizeof(T);
      append(&bytes, sizeof(bytes));
      append(values.data(), bytes);
    }
  }

  void write_appended() {
    if (encoding_ == VtpEncoding::ascii) return;
    stream_ << "<AppendedData encoding=\"raw\">\n_";
    stream_.write(appended_.data(), static_cast<std::streamsize>(appended_.size()));
    stream_ << "\n</AppendedData>\n";
  }

 private:
  static const char* type_name(float) { return "Float32"; }
  static const char* type_name(std::int32_t) { return "Int32"; }

  void append(const void* data, std::size_t bytes) {
    const auto* first = static_cast<const char*>(data);
    appended_.insert(appended_.end(), first, first + bytes);
  }

  VtpEncoding encoding_;
  std::ostream& stream_;
  std::vector<char> appended_;
};

std::vector<float> to_floats(const VertexField& field) {
  const int count = field.groups().vertex_count();
  std::vector<float> values;
  values.reserve(3 * count);
  for (int v = 0; v < count; ++v) {
    for (const double coordinate : field.get(v)) values.push_back(static_cast<float>(coordinate));
  }
  return values;
}

template <class T, class Value>
std::vector<T> list(int count, const Value& value) {
  std::vector<T> values(count);
  for (int i = 0; i < count; ++i) values[i] = static_cast<T>(value(i));
  return values;
}

}  // namespace

void write_vtp(const Strands& strands, const State& state, VtpEncoding encoding,
               std::ostream& stream) {
  const int vertices = strands.vertex_count();
  ArrayWriter arrays(encoding, stream);
  stream << fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" "
      "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n"
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}"
      "</DataArray>\n</FieldData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n",
      std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian", state.time,
      vertices, strands.count());
  arrays.write("radius", 1, list<float>(vertices, [&](int v) { return strands.radius(v); }));
  arrays.write("velocity", 3, to_floats(state.velocities));
  arrays.write("strand", 1,
               list<std::int32_t>(vertices, [&](int v) { return strands.strand_of(v); }));
  stream << "</PointData>\n<Points>\n";
  arrays.write("Points", 3, to_floats(state.positions));
  stream << "</Points>\n<Lines>\n";
  arrays.write("connectivity", 1, list<std::int32_t>(vertices, [](int v) { return v; }));
  arrays.write("offsets", 1, list<std::int32_t>(strands.count(), [&](int strand) {
                 return strands.first(strand + 1);
               }));
  stream << "</Lines>\n</Piece>\n</PolyData>\n";
  arrays.write_appended();
  stream << "</VTKFile>\n";
}

}  // namespace ringlet
