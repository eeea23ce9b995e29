// SPDX-License-Identifier: GPL-2.0-only
#include "files/pvd_collection.h"

#include <gtest/gtest.h>

using namespace encased_column;

// The form is that of ParaView's documentation of the PVD file format.
TEST(PvdCollection, ListsItsFilesAsParaViewReadsThem)
{
  PvdCollection series;
  series.add(0.0, "a_0.vtp");
  series.add(0.1, "a_1.vtp");
  EXPECT_EQ(series.text(),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
            "  <Collection>\n"
            "    <DataSet timestep=\"0\" part=\"0\" file=\"a_0.vtp\"/>\n"
            "    <DataSet timestep=\"0.1\" part=\"0\" file=\"a_1.vtp\"/>\n"
            "  </Collection>\n"
            "</VTKFile>\n");
}

TEST(PvdCollection, IsCompleteBeforeTheFirstFile)
{
  EXPECT_NE(PvdCollection().text().find("</VTKFile>"), std::string::npos);
}

TEST(PvdCollection, DropsWhatIsNotEarlierWhenTheRunGoesBack)
{
  PvdCollection series;
  for (const double time : {0.0, 1.0, 2.0, 3.0})
    series.add(time, "a_" + std::to_string(time) + ".vtp");
  series.add(1.5, "b.vtp");
  ASSERT_EQ(series.entries().size(), 3u);
  EXPECT_EQ(series.entries()[1].time, 1.0);
  EXPECT_EQ(series.entries()[2].file, "b.vtp");
}

TEST(PvdCollection, HoldsOneFilePerTime)
{
  PvdCollection series;
  series.add(0.5, "a.vtp");
  series.add(0.5, "a.vtp");
  EXPECT_EQ(series.entries().size(), 1u);
}

TEST(PvdCollection, KeepsTimesApartThatDifferInTheTenthDigit)
{
  PvdCollection series;
  series.add(100.0, "a.vtp");
  series.add(100.0000001, "b.vtp");
  EXPECT_NE(series.text().find("\"100.0000001\""), std::string::npos);
}

TEST(PvdCollection, WritesNamesThatXmlWouldMistake)
{
  PvdCollection series;
  series.add(0.0, "sand & <gravel>.vtp");
  EXPECT_NE(series.text().find("\"sand &amp; &lt;gravel>.vtp\""), std::string::npos);
}

// Parts of one time stand together, each a block of its own by number and name.
TEST(PartsTogether, AreListedByTimeInTheirOrder)
{
  const std::vector<PvdEntry> together =
      parts_together({{"grains", "g", {{0.0, "g_0.vtp"}, {0.2, "g_2.vtp"}}},
                      {"sleeve", "s", {{0.0, "s_0.vtp"}, {0.1, "s_1.vtp"}, {0.2, "s_2.vtp"}}}});
  EXPECT_EQ(pvd_text(together),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
            "  <Collection>\n"
            "    <DataSet timestep=\"0\" part=\"0\" name=\"grains\" file=\"g/g_0.vtp\"/>\n"
            "    <DataSet timestep=\"0\" part=\"1\" name=\"sleeve\" file=\"s/s_0.vtp\"/>\n"
            "    <DataSet timestep=\"0.1\" part=\"1\" name=\"sleeve\" file=\"s/s_1.vtp\"/>\n"
            "    <DataSet timestep=\"0.2\" part=\"0\" name=\"grains\" file=\"g/g_2.vtp\"/>\n"
            "    <DataSet timestep=\"0.2\" part=\"1\" name=\"sleeve\" file=\"s/s_2.vtp\"/>\n"
            "  </Collection>\n"
            "</VTKFile>\n");
}
