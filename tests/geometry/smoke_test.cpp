#include <gtest/gtest.h>
#include <cstdio>
#include "support/corpus.h"
#include "voronoi.h"
namespace apollonius::test {
TEST(Smoke, Areas) {
  for (const NamedGenerator& g : corpus()) { if (getenv("G") && g.name != getenv("G")) continue;
    Random random(1);
    Diagram d; 
    double worst=0, worst2=0;
    for (int run=0; run<20; ++run) {
    d.clear();
    const Circles cs = g.make(random, g.large?300:12);
    double lo=1e300, hi=-1e300;
    for (auto& c: cs) { SiteId id; ASSERT_EQ(d.insert(c.x,c.y,c.r,id), Error::kNone); lo=std::min({lo,c.x,c.y}); hi=std::max({hi,c.x,c.y}); }
    const double s=hi-lo; if(!(s>0)) continue;
    for (double f : {0.0, -0.3, 0.4, 3.0, 1e3}) {
    Voronoi v(d, {lo-f*s, lo-f*s*0.9, hi+f*s, hi+f*s*1.1});
    std::vector<double> areas;
    Error e=v.areas(areas); if(e!=Error::kNone) continue;
    double sum=0, sum2=0; const double W=(hi-lo+2*f*s)*(hi-lo+2*f*s);
    for (SiteId id=0; id<areas.size(); ++id) { sum+=areas[id]; CellMeasures m; EXPECT_EQ(v.measures(id,m),Error::kNone); sum2+=m.area; worst2=std::max(worst2,std::abs(m.area-areas[id])/W);}
    if(getenv("DUMP") && std::abs(sum/W-1)>1e-10) { for(auto&c:cs) std::printf("  site %a %a %a  (%g %g %g)\n",c.x,c.y,c.r,c.x,c.y,c.r); std::printf(" window %g %g %g %g\n",lo-f*s, lo-f*s*0.9, hi+f*s, hi+f*s*1.1); for(SiteId id=0;id<areas.size();++id) std::printf(" area %u %g\n",id,areas[id]/W); exit(1);}
    if(std::abs(sum/W-1)>1e-10) std::printf("   run %d f %g: %g\n",run,f,sum/W-1);
    worst=std::max(worst,std::abs(sum/W-1));
    }}
    std::printf("%s %g %g  %.2f s\n", g.name.c_str(), worst, worst2, (double)clock()/CLOCKS_PER_SEC);
  }
}
}
