// SPDX-License-Identifier: GPL-2.0-only
// What `encase doctor` makes of what it finds: one sentence each, and what to do.
#include "runner/doctor.h"

#include <gtest/gtest.h>

using namespace encased_column;
using Verdict = Finding::Verdict;

namespace {

void expect(const Finding& found, Verdict verdict, const std::string& sentence)
{
  EXPECT_EQ(found.verdict, verdict) << found.sentence;
  EXPECT_EQ(found.sentence, sentence);
}

}  // namespace

TEST(Doctor, SaysWhatToDoWhereAProgramIsMissingOrDoesNotStart)
{
  expect(judge_programs({0, "host: A\nMPI: B\n"}, "/usr/bin/x"), Verdict::good, "host: A, MPI: B");
  expect(judge_programs({127, ""}, "/usr/bin/x"), Verdict::bad,
         "LIGGGHTS with the plugin must lie beside this program, found no '/usr/bin/x', build or "
         "install both again");
  EXPECT_NE(judge_programs({1, "x: libvtk.so: cannot open\n\n"}, "")
                .sentence.find("found 'x: libvtk.so: cannot open'"),
            std::string::npos);
}

TEST(Doctor, SaysWhatToDoWhereMpiDoesNotStart)
{
  expect(judge_mpi({0, "", 0.64}, 2), Verdict::good, "mpirun started 2 ranks in 0.6 s");
  expect(judge_mpi({127, ""}, 2), Verdict::bad,
         "several ranks take the program mpirun, found none, write 'apt-get install openmpi-bin', "
         "or '--ranks 1' for each run");
  expect(judge_mpi({1, "-----\nno slots\n------\n"}, 2), Verdict::bad,
         "mpirun must start 2 ranks, found 'no slots', mend that, or write '--ranks 1' for each "
         "run");
}

TEST(Doctor, SaysWhatToDoWhereDiskOrMemoryIsShort)
{
  EXPECT_EQ(judge_disk(2e9, 1e8, "runs", true).verdict, Verdict::good);
  expect(judge_disk(5e7, 1e8, "runs", true), Verdict::bad,
         "the default job leaves 100 MB, found 50 MB free for 'runs', make room or write '--out "
         "DIR' with a folder of another disk");
  expect(judge_disk(2e9, 1e8, "/etc/runs", false), Verdict::bad,
         "results must go where files can be made, found that '/etc/runs' is closed, go to a "
         "folder of your own or write '--out DIR'");
  EXPECT_EQ(judge_memory(2e9, 1e8).verdict, Verdict::good);
  expect(judge_memory(5e7, 1e8), Verdict::bad,
         "the default job takes 100 MB of memory, found 50 MB, end other programs or write "
         "'--jobs 1'");
  EXPECT_EQ(judge_memory(0.0, 1e8).verdict, Verdict::note);
}

TEST(Doctor, MindsSlurmOnlyWhereItIs)
{
  EXPECT_EQ(judge_slurm({127, ""}).verdict, Verdict::note);
  EXPECT_EQ(judge_slurm({0, "Slurmctld(primary) at head is UP\n"}).verdict, Verdict::good);
  EXPECT_EQ(judge_slurm({0, "Slurmctld(primary) at head is DOWN\n"}).verdict, Verdict::bad);
  // What scontrol 22.05 says where there is no slurm.conf.
  const std::string alone = "scontrol: fatal: Could not establish a configuration source\n";
  EXPECT_EQ(judge_slurm({1, alone}).verdict, Verdict::note);
}

TEST(Doctor, EndsWithWhatToDoNext)
{
  EXPECT_EQ(doctor_text({{"MPI", Verdict::good, "starts"}, judge_cores(1)}),
            "ok  MPI    starts\n"
            "-   cores  1: tests run one after the other\n\n"
            "This machine has what the runs need: 'encase run' runs the default job\n");
  EXPECT_EQ(doctor_text({judge_display("pictures take a display"), judge_cores(2)}),
            "FAIL  pictures  pictures take a display\n"
            "ok    cores     2, as many tests at once\n\n"
            "1 thing needs mending: what to do stands behind FAIL\n");
}

// Measured: 46 MB with 3 100 grains, 116 MB with 40 800.
TEST(Doctor, KnowsTheMemoryOfACase)
{
  EXPECT_NEAR(memory_of_case(3100), 46e6, 6e6);
  EXPECT_NEAR(memory_of_case(40800), 116e6, 6e6);
  EXPECT_DOUBLE_EQ(available_memory("MemFree: 5 kB\nMemAvailable:   2000 kB\n"), 2048e3);
  EXPECT_DOUBLE_EQ(available_memory("MemFree: 5 kB\n"), 0.0);
}
